#!/usr/bin/env bash
# Runs one case of bad input or of exit status and checks what the program does:
#
#   bash run_case.sh STICTION CASE_FILE
#
# The program runs in the directory run/, made anew in the current directory.
# A case is a text file of lines
#
#   # what it is about
#   arguments: input.prm --set 'Section/Entry=value'    as for a shell
#   ranks: 2              MPI ranks, 1 if it is left out
#   status: 1             the exit status, of every rank
#   says: TEXT            stands in the message; any number of such lines
#   says not: TEXT        does not
#   interrupt: TEXT       Ctrl-C once TEXT stands on stdout, on every rank
#   memory: 4000000       at most so many kB for each rank
#   writes: nothing       no file is made or changed; the rule for status 1,
#                         unless 'writes: something' says otherwise
#   written: FILE         exists afterwards and is not empty
#   not written: FILE     does not exist afterwards
#   before: COMMAND       shell command before, "$stiction" is the program
#   after: COMMAND        shell command afterwards, which must succeed
#   prm:                  all lines below this one are the file input.prm;
#                         without it, input.prm is base.prm; what they do not
#                         set of the reference brick, brick.prm, is added below
#   prm alone:            the same, and nothing is added
#
# The message is what the program writes to stderr for status 1, to stdout for
# other statuses, for status 3 either. For status 1 it must be one line in all,
# from all ranks together: a sentence that begins with 'stiction: ' and ends with
# '.'. For statuses 0 and 2 nothing may be written to stderr.
set -u
stiction=$(realpath "$1")
case_file=$(realpath "$2")
errors=$(dirname "$(realpath "$0")")
memory=$(sed -n 's/^memory: *//p' "$case_file")
interrupt=$(sed -n 's/^interrupt: *//p' "$case_file")
export stiction errors memory interrupt
export OMPI_MCA_rmaps_base_oversubscribe=1 # more ranks than cores

all() { # all values of a key
  sed '/^prm\( alone\)\?:/,$d' "$case_file" | sed -n "s/^$1: *//p"
}
sum_of_everything() {
  find . -type f -exec cksum {} + | sort
  find . ! -type f | sort
}

what_is_not_set() { # what_is_not_set IN OF: the entries of a file
  awk '{ sub(/[ \t]*#.*/, "") }
       $1 == "subsection" { section = $0 }
       $1 == "set" { entry = $0; sub(/[ \t]*=.*/, "", entry)
                     sub(/^[ \t]*/, "", entry); entry = section entry }
       NR == FNR { if ($1 == "set") is_set[entry] = 1
                   if (entry ~ /Table 1 level$/) { # which says both
                     is_set[section "set Lengths"] = 1
                     is_set[section "set Subdivisions"] = 1
                   }
                   next }
       $1 == "set" && !(entry in is_set) { print section; print; print "end" }' \
    "$1" "$2"
}

failures=0
expect() { # expect TRUE-OR-FALSE-COMMAND... -- TEXT
  local command=()
  while [ "$1" != -- ]; do command+=("$1"); shift; done
  "${command[@]}" && return
  [ $failures -eq 0 ] && echo "$(basename "$case_file" .case): not as expected"
  failures=$((failures + 1))
  echo "  expected: $2"
}
same() { [ "$1" = "$2" ]; }
contains() { grep -qF -e "$2" "$1"; }
lacks() { ! contains "$@"; }

# ------------------------------------------------------------------- prepare
status=$(all status)
ranks=$(all ranks)
ranks=${ranks:-1}
rm -rf run stdout stderr statuses
mkdir run && cd run || exit 1
if grep -q '^prm alone:' "$case_file"; then
  sed '1,/^prm alone:/d' "$case_file" >input.prm
else
  if grep -q '^prm:' "$case_file"; then
    sed '1,/^prm:/d' "$case_file" >input.prm
  else
    cp "$errors/base.prm" input.prm
  fi
  added=$(what_is_not_set input.prm "$errors/brick.prm")
  echo "$added" >>input.prm
fi
writes=$(all writes)
[ "$status" = 1 ] && writes=${writes:-nothing}
if [ "$writes" = nothing ]; then
  mkdir results # of an earlier run, to be left alone
  echo '{"converged": true}' >results/summary.json
  echo 'an earlier run' >results/log.txt
fi
while read -r command; do
  bash -c "$command" >/dev/null || expect false -- "that '$command' succeeds"
done < <(all before)
before=$(sum_of_everything)

# ----------------------------------------------------------------------- run
# The ranks' own output and status, without what mpirun adds to them.
# shellcheck disable=SC2016 # expanded by the inner shell
each_rank='[ -z "$memory" ] || ulimit -v "$memory"
           "$stiction" "$@" >>../stdout 2>>../stderr </dev/null &
           if [ -n "$interrupt" ]; then
             until grep -qF -e "$interrupt" ../stdout || ! kill -0 $!; do
               sleep 0.01
             done
             kill -INT $!
           fi 2>/dev/null
           wait $!
           rank_status=$?; echo $rank_status >>../statuses; exit $rank_status'
arguments=()
eval "arguments=($(all arguments))"
touch ../stdout ../stderr ../statuses
if [ "$ranks" -eq 1 ]; then
  timeout -k 5 60 bash -c "$each_rank" stiction "${arguments[@]}"
else
  timeout -k 5 60 mpirun -n "$ranks" \
    bash -c "$each_rank" stiction "${arguments[@]}" >/dev/null 2>../mpirun
fi
end=$?
expect test $end -ne 124 -- "an end, but the program hangs"

# A notice of Open MPI stands between two lines of 74 '-', or after [host:pid].
dashes=$(printf '%74s' '' | tr ' ' -)
sed -i -e "/^$dashes\$/,/^$dashes\$/d" -e '/^\[[^]]*:[0-9]*\] /d' ../stderr

# --------------------------------------------------------------------- check
# mpirun ends with the first status that is not 0, and may kill other ranks then
expect same "$end" "$status" -- "exit status $status, not $end"
expect same "$(sort -u ../statuses)" "$status" -- \
  "exit status $status on all ranks, not $(sort -u ../statuses | paste -sd ,)"

message=../stdout
if [ "$status" = 1 ]; then
  message=../stderr
  expect same "$(wc -l <../stderr)" 1 -- \
    "one line on stderr, not $(wc -l <../stderr)"
  expect same "$(grep -c '^stiction: ' ../stderr)" 1 -- \
    "one sentence beginning with 'stiction: '"
  expect same "$(tail -c 2 ../stderr)" . -- "a sentence that ends with '.'"
  expect lacks ../stderr "internal error" -- "no internal error"
  for success in CERTIFIED 'NOT CONVERGED' 'is valid' ParaView; do
    expect lacks ../stdout "$success" -- "no '$success' on stdout"
  done
elif [ "$status" = 3 ]; then
  message=../said
  cat ../stdout ../stderr >../said
  expect lacks ../said "CERTIFIED: " -- "no certificate"
else
  expect test ! -s ../stderr -- "nothing on stderr"
fi
while IFS= read -r text; do
  expect contains $message "$text" -- "a message with: $text"
done < <(all says)
while IFS= read -r text; do
  expect lacks $message "$text" -- "a message without: $text"
done < <(all 'says not')

if [ "$writes" = nothing ]; then
  after=$(sum_of_everything)
  expect same "$before" "$after" -- "no file made or changed, but: $(
    diff <(echo "$before") <(echo "$after") | sed -n 's/^[<>] /\n            /p')"
fi
while IFS= read -r file; do
  expect test -s "$file" -- "a file $file"
done < <(all written)
while IFS= read -r file; do
  expect test ! -e "$file" -- "no file $file"
done < <(all 'not written')
while IFS= read -r command; do
  expect bash -c "$command" -- "that '$command' succeeds"
done < <(all after)

if [ $failures -ne 0 ]; then
  echo "  seen: stiction $(all arguments)"
  echo "  seen on stdout:"
  head -c 6000 ../stdout | sed 's/^/    /'
  echo "  seen on stderr:"
  head -c 6000 ../stderr | sed 's/^/    /'
  exit 1
fi
