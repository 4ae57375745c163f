#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# One shard of a sweep, as a task of a Slurm job array; submit.sh submits it. A task that Slurm puts
# back in the queue (a node that died, a preemption) goes on where it was.
#
#SBATCH --job-name=kinex-sweep
#SBATCH --ntasks=1
#SBATCH --mem=4500
#SBATCH --time=02:00:00
#SBATCH --requeue
#SBATCH --open-mode=append
exec kinex sweep run "$1" --shard "$SLURM_ARRAY_TASK_ID/$2" -o "$3"
