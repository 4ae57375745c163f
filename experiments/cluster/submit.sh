#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# Submits a sweep to Slurm: an array of SHARDS tasks, AT_ONCE of them at a time, and a job that merges
# when all have ended, well or not. Prints the numbers of both jobs.
#
# usage: submit.sh PLAN FOLDER SHARDS AT_ONCE [OPTION OF sbatch ..]
#
# FOLDER is on a file system that all nodes share; kinex is in PATH on all of them. Options override
# those of shard.sh: --mem should hold the plan's megabytes, --time what `kinex sweep status` expects.
# The same command goes on; --array=3,7 submits single shards again.
set -eu
here=$(dirname "$0")
# shellcheck source-path=SCRIPTDIR source=arguments.sh
. "$here/arguments.sh"
check_arguments "submit.sh PLAN FOLDER SHARDS AT_ONCE [OPTION OF sbatch ..]" "$@"
plan=$1 folder=${2%/} shards=$3 at_once=$4
shift 4
mkdir -p "$folder/log"
job=$(sbatch --parsable --array="0-$((shards - 1))%$at_once" --output="$folder/log/%A_%a.txt" "$@" \
  "$here/shard.sh" "$plan" "$shards" "$folder")
merge=$(sbatch --parsable --dependency="afterany:$job" --job-name=kinex-merge --output="$folder/log/merge-%j.txt" \
  --wrap "exec kinex sweep merge '$folder' -o '$folder.sqlite' --force")
echo "$job $merge"
