#!/bin/sh
# A tolerance study of every program in a folder, one process a program, and one table of them all.
#
#   nightly_study.sh PROGRAMS RESULTS [OPTION OF feedscope compare]...
#
# Writes RESULTS/PROGRAM.json and .txt for each program, PROGRAM.failed with the reason where a program could not
# be studied, and RESULTS/study.csv and .txt, the table of all that could. Exit code 0: all were studied, 1: some
# were not (listed at the end), 2: none.
# JOBS: processes at a time [the processors]; FEEDSCOPE: the executable [feedscope].
# With GNU parallel instead of xargs:   ls PROGRAMS/* | parallel --bar nightly_study.sh --one {} RESULTS
#                                       then: nightly_study.sh --merge RESULTS
# As job N of a cluster's job array:    nightly_study.sh --job N PROGRAMS RESULTS, then --merge RESULTS
# (Slurm: sbatch --array=1-$(ls PROGRAMS | wc -l) --wrap 'nightly_study.sh --job $SLURM_ARRAY_TASK_ID ...')
set -eu
feedscope=${FEEDSCOPE:-feedscope}
script=$(cd "$(dirname "$0")" && pwd)/$(basename "$0")

programs_in() {
  find "$1" -maxdepth 1 -type f -print0 | sort -z
}

# A program with errors in it (exit code 1) is studied as far as it could be read. What an earlier night left of a
# program goes first, so that the table never shows it for this one.
one() {
  program=$1 results=$2
  shift 2
  [ $# -gt 0 ] || set -- --model essid --sweep tolerance=0.005:0.1:log8 --within 0.02
  mkdir -p "$results"
  name=$results/$(basename "$program")
  rm -f "$name.json" "$name.txt"
  echo "did not finish" > "$name.failed"
  status=0
  "$feedscope" compare "$program" "$@" --json "$name.json" > "$name.txt" 2> "$name.log" || status=$?
  cat "$name.log" >&2
  if [ "$status" -le 1 ]; then
    rm -f "$name.failed"
  else
    { cat "$name.log"; echo "exit code $status"; } > "$name.failed"
    rm -f "$name.txt"
  fi
  rm -f "$name.log"
  [ "$status" -le 1 ]
}

# The table of everything that was studied, then what was not.
merge() {
  results=$1
  shift
  studied=0 failed=0
  for file in "$results"/*.json; do
    [ ! -e "$file" ] || studied=$((studied + 1))
  done
  rm -f "$results/study.csv" "$results/study.txt"
  if [ "$studied" -gt 0 ]; then
    "$feedscope" compare "$@" --merge "$results"/*.json --csv "$results/study.csv" > "$results/study.txt"
    cat "$results/study.txt"
  fi
  for file in "$results"/*.failed; do
    [ -e "$file" ] || continue
    [ "$failed" -gt 0 ] || echo "Not studied, and not in the table:" >&2
    failed=$((failed + 1))
    echo "  $(basename "$file" .failed): $(tail -n 2 "$file" | tr '\n' ' ')" >&2
  done
  [ "$studied" -gt 0 ] || { echo "nightly_study.sh: no program was studied; '$results' holds no results" >&2; exit 2; }
  [ "$failed" -eq 0 ] || exit 1
}

case ${1:-} in
  --one) shift; one "$@" ;;
  --merge) shift; merge "$@" ;;
  --job)
    job=$2 programs=$3 results=$4
    shift 4
    program=$(programs_in "$programs" | tr '\0\n' '\n\0' | sed -n "${job}p" | tr '\0' '\n')
    [ -n "$program" ] || { echo "nightly_study.sh: '$programs' has no program number $job" >&2; exit 2; }
    one "$program" "$results" "$@"
    ;;
  -* | '') sed -n '2,15s/^# \{0,1\}//p' "$0" >&2; exit 2 ;;
  *)
    programs=$1 results=$2
    shift 2
    mkdir -p "$results"
    programs_in "$programs" |
      xargs -0 -r -P "${JOBS:-$(nproc)}" -I '{}' sh "$script" --one '{}' "$results" "$@" || true
    merge "$results"
    ;;
esac
