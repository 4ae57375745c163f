-- SPDX-License-Identifier: GPL-3.0-or-later
-- The tables of verify.sqlite, which kinex verify writes. Exact values are TEXT; verdicts are PASS, AGREES (of a
-- part of the sizes: --quick), INCONCLUSIVE, GAVE UP or FAIL. The program makes its tables from this file.

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

-- One structure on one workload and size: what is asked, and the verdict on all of its claims.
CREATE TABLE cell(
  id INTEGER PRIMARY KEY,
  structure TEXT NOT NULL,       -- name as in "maintain"
  workload TEXT NOT NULL,        -- name of kinex gen
  family TEXT NOT NULL,          -- cells that differ in size alone have one family; empty: none
  params_json TEXT NOT NULL,     -- n, degree, dimension, first_seed, seeds, mirrored; m, separation, turns where they matter
  question TEXT NOT NULL,        -- in a sentence
  verdict TEXT NOT NULL,         -- the worst of its claims
  exact_over_double TEXT,        -- CPU time of exact over that of double, where both see the same events
  wall_s REAL NOT NULL,          -- seconds of the clock
  UNIQUE(structure, workload, params_json)
) STRICT;

-- One run: a scene of a cell, by seed and arithmetic.
CREATE TABLE run(
  id INTEGER PRIMARY KEY,
  cell_id INTEGER NOT NULL REFERENCES cell(id),        -- its cell
  build_id INTEGER NOT NULL REFERENCES build(id),      -- 1
  machine_id INTEGER NOT NULL REFERENCES machine(id),  -- 1
  scene TEXT NOT NULL,           -- name of the scene
  scene_hash TEXT NOT NULL,      -- SHA-256 of its file, as kinex gen writes it
  structure TEXT NOT NULL,       -- as in the cell
  number_mode TEXT NOT NULL,     -- the arithmetic
  seed INTEGER NOT NULL,         -- as of kinex gen --seed
  objects INTEGER NOT NULL,      -- of the scene
  status TEXT NOT NULL,          -- done, limit or interrupted
  started_utc TEXT NOT NULL,     -- date and time
  cpu_s REAL NOT NULL,           -- CPU seconds
  peak_kb INTEGER NOT NULL,      -- memory of the run's own tables
  UNIQUE(cell_id, seed, number_mode)
) STRICT;

-- Sums over a run; what is 0 has no row.
CREATE TABLE counter(
  run_id INTEGER NOT NULL REFERENCES run(id),          -- its run
  name TEXT NOT NULL,            -- processed, external, internal, kind.K, instants, rebuilds, certificates_created, signs.PREDICATE, ..
  stage TEXT NOT NULL,           -- which arithmetic stage answered (double, wide, multiprecision, exact), or a degree; else empty
  value INTEGER NOT NULL,        -- how many
  PRIMARY KEY(run_id, name, stage)
) STRICT, WITHOUT ROWID;

-- Largest values within a run.
CREATE TABLE extreme(
  run_id INTEGER NOT NULL REFERENCES run(id),          -- its run
  name TEXT NOT NULL,            -- certificates_live, certificates_per_object, created_per_event, queue, bytes, coefficient_bits, ..
  value_text TEXT NOT NULL,      -- an integer
  PRIMARY KEY(run_id, name)
) STRICT, WITHOUT ROWID;

-- Every expectation, hard bound and audit of a cell.
CREATE TABLE claim_result(
  claim_id TEXT NOT NULL,        -- name of the claim
  cell_id INTEGER NOT NULL REFERENCES cell(id),        -- its cell
  quantity TEXT NOT NULL,        -- what is counted
  kind TEXT NOT NULL,            -- exact, at most, at least, witness, mean, bound, audit, ..
  run_id INTEGER REFERENCES run(id),                   -- the run that decided; none: all of them
  expected TEXT NOT NULL,        -- as shown in the table
  observed TEXT NOT NULL,        -- as shown in the table
  verdict TEXT NOT NULL,         -- see above
  source TEXT NOT NULL,          -- theorem or paper
  PRIMARY KEY(claim_id, cell_id, quantity)
) STRICT, WITHOUT ROWID;

-- A growth claim on a family of sizes: the fit of log count against log size.
CREATE TABLE growth(
  claim_id TEXT NOT NULL,        -- name of the claim
  structure TEXT NOT NULL,       -- the structure
  family TEXT NOT NULL,          -- the cells it is fitted over
  quantity TEXT NOT NULL,        -- what is counted
  points INTEGER NOT NULL,       -- sizes that are fitted
  expected TEXT NOT NULL,        -- the claimed law
  exponent TEXT,                 -- fitted; this and the next nine are NULL where there is no fit
  lower_95 TEXT,                 -- of its 95 % interval
  upper_95 TEXT,                 -- of its 95 % interval
  chi_square TEXT,               -- of the residuals; NULL where the counts do not scatter
  degrees INTEGER,               -- degrees of freedom
  corrected_law TEXT,            -- the same with a term of lower order
  corrected_exponent TEXT,       -- as exponent
  corrected_lower_95 TEXT,       -- as lower_95
  corrected_upper_95 TEXT,       -- as upper_95
  corrected_chi_square TEXT,     -- as chi_square
  corrected_degrees INTEGER,     -- as degrees
  verdict TEXT NOT NULL,         -- see above
  source TEXT NOT NULL,          -- theorem or paper
  PRIMARY KEY(claim_id, structure)
) STRICT, WITHOUT ROWID;

-- The claimed law, and those that are easily taken for it, on the same counts.
CREATE TABLE neighbour(
  claim_id TEXT NOT NULL,        -- as in growth
  structure TEXT NOT NULL,       -- as in growth
  law TEXT NOT NULL,             -- "n log n", ..
  standing TEXT NOT NULL,        -- claimed, beaten, better or undecided
  chi_square TEXT,               -- of the residuals; NULL where the counts do not scatter
  degrees INTEGER NOT NULL,      -- degrees of freedom
  scatter TEXT NOT NULL,         -- of the residuals
  lead TEXT NOT NULL,            -- how much worse than the claimed law
  PRIMARY KEY(claim_id, structure, law),
  FOREIGN KEY(claim_id, structure) REFERENCES growth(claim_id, structure)
) STRICT, WITHOUT ROWID;

-- Experiments that are not one structure on one workload.
CREATE TABLE study(
  name TEXT NOT NULL,            -- of the study
  claim_id TEXT NOT NULL,        -- name of the claim
  expected TEXT NOT NULL,        -- as shown in the table
  observed TEXT NOT NULL,        -- as shown in the table
  verdict TEXT NOT NULL,         -- see above
  source TEXT NOT NULL,          -- theorem or paper
  PRIMARY KEY(name, claim_id)
) STRICT, WITHOUT ROWID;
