#!/usr/bin/env bash
# Measures a chart in shards, as a Slurm job array. Each task measures one shard; a task that is queued again continues.
#   sbatch --array=1-8 scripts/chart-slurm.sh FOLDER --scene all --size 1280x720
#   build/release/momentscope merge FOLDER/chart-*.csv -o FOLDER/chart.html
# FOLDER must exist. The words after it are passed to `momentscope chart`. Each task has a node of its own, so that tasks do
# not disturb each other's times. MOMENTSCOPE names the program if it is not in this repository's build/release.
#SBATCH --job-name=momentscope-chart
#SBATCH --exclusive
#SBATCH --nodes=1
#SBATCH --time=02:00:00
#SBATCH --requeue
set -euo pipefail
if [ $# -lt 1 ] || [ ! -d "$1" ] || [ -z "${SLURM_ARRAY_TASK_ID:-}" ]; then
    echo "Submit it as: sbatch --array=1-8 scripts/chart-slurm.sh FOLDER [options of momentscope chart]" >&2
    exit 1
fi
folder=$1
shift
# Slurm runs a copy of this file. The repository is the folder from which the job was submitted.
momentscope=${MOMENTSCOPE:-${SLURM_SUBMIT_DIR:-.}/build/release/momentscope}
# Times of software renderers depend on the number of threads.
export LP_NUM_THREADS=${LP_NUM_THREADS:-${SLURM_CPUS_ON_NODE:-2}}
exec "$momentscope" chart "$@" --shard "$SLURM_ARRAY_TASK_ID/$SLURM_ARRAY_TASK_COUNT" \
    -o "$folder/chart-$SLURM_ARRAY_TASK_ID.csv"
