#!/bin/sh
# A tolerance study of every program in a folder, one process a program, and one table of them all.
#
#   nightly_study.sh PROGRAMS RESULTS [OPTION OF feedscope compare]...
#
# JOBS: processes at a time [the processors]; FEEDSCOPE: the executable [feedscope].
# With GNU parallel instead of xargs:   ls PROGRAMS/* | parallel --bar nightly_study.sh --one {} RESULTS
# As job N of a cluster's job array:    nightly_study.sh --job N PROGRAMS RESULTS, then --merge RESULTS
# (Slurm: sbatch --array=1-$(ls PROGRAMS | wc -l) --wrap 'nightly_study.sh --job $SLURM_ARRAY_TASK_ID ...')
set -eu
feedscope=${FEEDSCOPE:-feedscope}

# A program with errors in it (exit code 1) is studied as far as it could be read.
one() {
  program=$1 results=$2
  shift 2
  [ $# -gt 0 ] || set -- --model essid --sweep tolerance=0.005:0.1:log8 --within 0.02
  status=0
  "$feedscope" compare "$program" "$@" --json "$results/$(basename "$program").json" \
    > "$results/$(basename "$program").txt" || status=$?
  [ "$status" -le 1 ]
}

merge() {
  "$feedscope" compare --merge "$1"/*.json --csv "$1/study.csv" > "$1/study.txt"
  cat "$1/study.txt"
}

case ${1:-} in
  --one) shift; one "$@" ;;
  --merge) merge "$2" ;;
  --job)
    job=$2 programs=$3 results=$4
    shift 4
    mkdir -p "$results"
    one "$(find "$programs" -maxdepth 1 -type f | sort | sed -n "${job}p")" "$results" "$@"
    ;;
  -* | '') sed -n '2,10s/^# \{0,1\}//p' "$0" >&2; exit 2 ;;
  *)
    programs=$1 results=$2
    shift 2
    mkdir -p "$results"
    find "$programs" -maxdepth 1 -type f -print0 | sort -z |
      xargs -0 -P "${JOBS:-$(nproc)}" -I '{}' "$0" --one '{}' "$results" "$@"
    merge "$results"
    ;;
esac
