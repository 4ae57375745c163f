-- SPDX-License-Identifier: GPL-3.0-or-later
-- The tables that kinex sweep merge writes. Those up to "violation" hold exact results alone: they are, byte for byte, the
-- same whatever shards, order and machines ran the plan. The program makes its tables from this file.

CREATE TABLE plan(
  id INTEGER PRIMARY KEY,
  name TEXT NOT NULL,            -- its name
  hash TEXT NOT NULL UNIQUE,     -- SHA-256 of the plan
  plan_json TEXT NOT NULL        -- the plan itself
) STRICT;

-- One unit of work.
CREATE TABLE cell(
  id INTEGER PRIMARY KEY,
  key TEXT NOT NULL UNIQUE,      -- SHA-256 of its canonical JSON
  structure TEXT NOT NULL,       -- what is maintained
  workload TEXT NOT NULL,        -- name of kinex gen
  params_json TEXT NOT NULL,     -- the cell itself, canonical JSON
  status TEXT NOT NULL,          -- done, failed, refused, limit, memory, crash or killed; missing: no attempt has ended
  message TEXT NOT NULL          -- why it is not done; else empty
) STRICT;

-- A cell may belong to several plans.
CREATE TABLE plan_cell(
  plan_id INTEGER NOT NULL REFERENCES plan(id),  -- the plan
  cell_id INTEGER NOT NULL REFERENCES cell(id),  -- the cell
  PRIMARY KEY(plan_id, cell_id)
) STRICT, WITHOUT ROWID;

-- The run of a cell.
CREATE TABLE run(
  id INTEGER PRIMARY KEY,
  cell_id INTEGER NOT NULL UNIQUE REFERENCES cell(id),  -- its cell
  scene TEXT NOT NULL,           -- name of the scene
  scene_hash TEXT NOT NULL,      -- SHA-256 of its file
  number_mode TEXT NOT NULL,     -- the arithmetic
  seed TEXT,                     -- up to 2^64 - 1; NULL: the workload has none
  objects INTEGER NOT NULL,      -- of the scene
  digest TEXT NOT NULL,          -- of its events
  status TEXT NOT NULL           -- done or limit
) STRICT;

-- Sums over a run.
CREATE TABLE counter(
  run_id INTEGER NOT NULL REFERENCES run(id),    -- its run
  structure TEXT NOT NULL,       -- label; empty: of the whole run
  name TEXT NOT NULL,            -- processed, external, kind.K, certificates_created, ..
  value INTEGER NOT NULL,        -- how many
  PRIMARY KEY(run_id, structure, name)
) STRICT, WITHOUT ROWID;

-- Largest values within a run.
CREATE TABLE extreme(
  run_id INTEGER NOT NULL REFERENCES run(id),    -- its run
  structure TEXT NOT NULL,       -- label; empty: of the whole run
  name TEXT NOT NULL,            -- certificates_live, certificates_per_object, ..
  value_text TEXT NOT NULL,      -- an integer
  PRIMARY KEY(run_id, structure, name)
) STRICT, WITHOUT ROWID;

-- The hard bounds of a run.
CREATE TABLE bound(
  run_id INTEGER NOT NULL REFERENCES run(id),    -- its run
  structure TEXT NOT NULL,       -- label
  number INTEGER NOT NULL,       -- from 1, in the order in which the structure registers them
  bound_id TEXT NOT NULL,        -- its name
  bound TEXT NOT NULL,           -- an exact number
  observed TEXT NOT NULL,        -- an exact number
  holds INTEGER NOT NULL,        -- 1 or 0
  source TEXT NOT NULL,          -- theorem or paper
  PRIMARY KEY(run_id, structure, number)
) STRICT, WITHOUT ROWID;

-- What audits found wrong.
CREATE TABLE violation(
  run_id INTEGER NOT NULL REFERENCES run(id),    -- its run
  number INTEGER NOT NULL,       -- from 1
  what TEXT NOT NULL,            -- in a sentence
  PRIMARY KEY(run_id, number)
) STRICT, WITHOUT ROWID;

-- One row for each file of attempts: who ran it, with what, where.
CREATE TABLE provenance(
  id INTEGER PRIMARY KEY,
  file TEXT NOT NULL,            -- the attempt file
  plan_id INTEGER NOT NULL REFERENCES plan(id),  -- its plan
  version TEXT NOT NULL,         -- "kinex 0.1.0"
  git_commit TEXT NOT NULL,      -- of the sources
  dirty INTEGER NOT NULL,        -- 1: they were changed since that commit
  compiler TEXT NOT NULL,        -- with its version
  flags TEXT NOT NULL,           -- build type and compiler flags
  libraries TEXT NOT NULL,       -- GMP, MPFR, .. with their versions
  cpu TEXT NOT NULL,             -- name of the processor
  cores INTEGER NOT NULL,        -- that the process could use
  memory_kb INTEGER NOT NULL,    -- of the machine
  kernel TEXT NOT NULL,          -- operating system
  host TEXT NOT NULL,            -- name of the machine
  command TEXT NOT NULL,         -- the command line
  shard TEXT NOT NULL,           -- "I/N"
  job TEXT NOT NULL,             -- of a batch system; else empty
  started_utc TEXT NOT NULL      -- date and time
) STRICT;

-- Every attempt at a cell.
CREATE TABLE attempt(
  id INTEGER PRIMARY KEY,
  provenance_id INTEGER NOT NULL REFERENCES provenance(id),  -- its file
  line INTEGER NOT NULL,         -- of that file
  cell_id INTEGER NOT NULL REFERENCES cell(id),  -- its cell
  status TEXT NOT NULL,          -- as of a cell
  signal INTEGER NOT NULL,       -- that ended the process; 0: none
  code INTEGER NOT NULL,         -- exit code
  message TEXT NOT NULL,         -- why it is not done; else empty
  limit_s INTEGER NOT NULL,      -- limit of CPU seconds; 0: none
  limit_mb INTEGER NOT NULL,     -- limit of address space; 0: none
  simulate_s REAL NOT NULL,      -- CPU seconds of the simulation
  cpu_s REAL NOT NULL,           -- CPU seconds of the process
  wall_s REAL NOT NULL,          -- seconds of the clock
  peak_kb INTEGER NOT NULL,      -- memory of the process
  ended_utc TEXT NOT NULL,       -- date and time
  UNIQUE(provenance_id, line)
) STRICT;
