-- SPDX-License-Identifier: GPL-3.0-or-later
-- The tables of trade.sqlite, which kinex trade writes. Every run is compared with the exact run of its scene. The
-- program makes its tables from this file.

-- The program that made the database: one row.
CREATE TABLE build(
  id INTEGER PRIMARY KEY,        -- 1
  program TEXT NOT NULL,         -- "kinex 0.1.0"
  git_commit TEXT NOT NULL,      -- of the sources
  dirty INTEGER NOT NULL,        -- 1: they were changed since that commit
  compiler TEXT NOT NULL,        -- with its version
  flags TEXT NOT NULL,           -- build type and compiler flags
  libraries TEXT NOT NULL        -- GMP, MPFR, .. with their versions
) STRICT;

-- The machine that it ran on: one row.
CREATE TABLE machine(
  id INTEGER PRIMARY KEY,        -- 1
  cpu TEXT NOT NULL,             -- name of the processor
  cores INTEGER NOT NULL,        -- that the process could use
  memory_kb INTEGER NOT NULL,    -- of the machine
  kernel TEXT NOT NULL           -- operating system
) STRICT;

-- A scene and a structure, and its exact run.
CREATE TABLE trade_case(
  id INTEGER PRIMARY KEY,
  build_id INTEGER NOT NULL REFERENCES build(id),      -- 1
  machine_id INTEGER NOT NULL REFERENCES machine(id),  -- 1
  structure TEXT NOT NULL,       -- name as in "maintain"
  name TEXT NOT NULL,            -- workload and size, or the scene's file
  scene TEXT NOT NULL,           -- name of the scene
  scene_hash TEXT NOT NULL,      -- SHA-256 of its file
  objects INTEGER NOT NULL,      -- of the scene
  degree INTEGER NOT NULL,       -- of the motion
  seed INTEGER NOT NULL,         -- as of kinex gen --seed
  events INTEGER NOT NULL,       -- log records of the exact run
  instants INTEGER NOT NULL,     -- different event times
  bits_most INTEGER,             -- bits that tell all neighbouring instants apart; NULL: fewer than two instants
  bits_99 INTEGER,               -- bits that tell 99 % of the neighbours apart
  bits_time TEXT,                -- where the most are needed
  problem TEXT,                  -- why there is no exact run; NULL: there is one
  wall_s REAL NOT NULL           -- seconds of the clock, all runs together
) STRICT;

-- One arithmetic on one case.
CREATE TABLE trade_run(
  case_id INTEGER NOT NULL REFERENCES trade_case(id),  -- its case
  arithmetic TEXT NOT NULL,      -- exact, sturm, double, gsl, mpfr:P
  standing TEXT NOT NULL,        -- same, valid or wrong
  ending TEXT NOT NULL,          -- ended, corrupt, endless, gave up or threw
  trouble TEXT,                  -- what it threw, or what the structure detected
  guard_fired INTEGER NOT NULL,  -- 1: repairs or rebuilds of one instant did not end
  cpu_s REAL,                    -- CPU seconds; NULL: it did not end
  time_over_double TEXT,         -- CPU time over that of double
  peak_bytes INTEGER NOT NULL,   -- memory of the run's own tables
  memory_over_double TEXT,       -- the same over that of double
  events INTEGER NOT NULL,       -- log records
  missed INTEGER NOT NULL,       -- events of the exact run only
  invented INTEGER NOT NULL,     -- events of this run only
  inversions INTEGER NOT NULL,   -- pairs of matched events in the wrong order
  first_event INTEGER,           -- number (from 1) of the first event that is not due; NULL: none
  first_time TEXT,               -- time of the event that was due
  error_s REAL NOT NULL,         -- largest error of a matched event's time, in the scene's unit of time
  error_ulps TEXT NOT NULL,      -- the same in units in the last place of a double
  checkpoints INTEGER NOT NULL,  -- states that were audited exactly, during the run
  valid INTEGER NOT NULL,        -- how many of them were valid
  valid_at_end INTEGER NOT NULL, -- 1: the last state is
  first_wrong TEXT,              -- time of the first state that is not; NULL: none
  violation TEXT,                -- what is wrong with it
  PRIMARY KEY(case_id, arithmetic)
) STRICT, WITHOUT ROWID;

-- Bits that the instants of random scenes need, by size.
CREATE TABLE bits(
  structure TEXT NOT NULL,       -- name as in "maintain"
  family TEXT NOT NULL,          -- the workload
  n INTEGER NOT NULL,            -- objects
  scenes INTEGER NOT NULL,       -- how many
  instants TEXT NOT NULL,        -- mean number of different event times
  most_mean TEXT NOT NULL,       -- mean of bits_most over the scenes
  most_error TEXT NOT NULL,      -- its standard error
  most_largest TEXT NOT NULL,    -- largest bits_most
  p99_mean TEXT NOT NULL,        -- mean of bits_99
  p99_error TEXT NOT NULL,       -- its standard error
  PRIMARY KEY(structure, family, n)
) STRICT, WITHOUT ROWID;

-- How the bits grow with n.
CREATE TABLE bits_growth(
  structure TEXT NOT NULL,       -- as in bits
  family TEXT NOT NULL,          -- as in bits
  quantity TEXT NOT NULL,        -- most or percentile_99
  bits_per_doubling TEXT NOT NULL,  -- fitted
  lower_95 TEXT NOT NULL,        -- of its 95 % interval
  upper_95 TEXT NOT NULL,        -- of its 95 % interval
  factor TEXT NOT NULL,          -- 2^bits at n = 1, by the fit
  PRIMARY KEY(structure, family, quantity)
) STRICT, WITHOUT ROWID;
