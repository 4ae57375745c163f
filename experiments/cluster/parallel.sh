#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# A sweep on one machine by GNU parallel, or on several by its --sshlogin.
#
# usage: parallel.sh PLAN FOLDER SHARDS JOBS [OPTION OF parallel ..]
#
# The same command goes on after a kill: finished cells are read from FOLDER, never from the job log.
# FOLDER.sqlite is merged anew each time.
set -eu
here=$(dirname "$0")
# shellcheck source-path=SCRIPTDIR source=arguments.sh
. "$here/arguments.sh"
check_arguments "parallel.sh PLAN FOLDER SHARDS JOBS [OPTION OF parallel ..]" "$@"
plan=$1 folder=${2%/} shards=$3 jobs=$4
shift 4
mkdir -p "$folder"
failed=0
seq 0 $((shards - 1)) | parallel --will-cite -q -j "$jobs" --joblog "$folder/jobs.log" "$@" \
  kinex sweep run "$plan" --shard "{}/$shards" -o "$folder" || failed=$?
[ "$failed" -eq 0 ] || echo "parallel.sh: shards with cells that failed or reached a limit: $failed" >&2
exec kinex sweep merge "$folder" -o "$folder.sqlite" --force
