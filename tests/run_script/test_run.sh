#!/usr/bin/env bash
# How ./run understands its command line, with a program that only pretends:
#
#   bash test_run.sh RUN
set -u
run=$(realpath "$1")
root=$(mktemp -d)
trap 'rm -rf "$root"' EXIT
mkdir "$root"/{bin,build,output,results}
cp "$run" "$root/run"
echo 'picture: xauth' >"$root/packages.txt"
cd "$root" || exit 1
touch a.prm

stub() { # stub FILE: a script from stdin
  { echo '#!/usr/bin/env bash' && cat; } >"$1"
  chmod +x "$1"
}
cat >build/build.ninja <<'END'
rule nothing
  command = true
build stiction: phony
END
stub build/stiction <<'END'
case " $* " in *" --print-output-directory "*) echo results; exit ;; esac
echo "stiction $*"
sleep 1.1 # file systems may count whole seconds
[ "${STATUS:-0}" = 1 ] || touch results/summary.json
exit "${STATUS:-0}"
END
stub bin/mpirun <<'END'
[ "$1 $2 $3" = '--quiet --oversubscribe -n' ] && echo "ranks $4" && shift 4 && "$@"
END
stub bin/setsid <<<'"$@"'
stub bin/dpkg-query <<<'echo "install ok installed"'
stub bin/xvfb-run <<<'echo "picture of ${!#}"'
export PATH=$root/bin:$PATH

failures=0
check() { # check STATUS TEXT ARGUMENTS...: status and output, in one line
  local status=$1 text=$2 seen end
  shift 2
  seen=$(./run "$@" 2>&1)
  end=$?
  seen=$(echo "$seen" | paste -sd '|')
  [ "$end" = "$status" ] && [ "$seen" = "$text" ] && return
  echo "./run $*: expected status $status, '$text'"
  echo "  seen status $end, '$seen'"
  failures=$((failures + 1))
}

picture='picture of results'
check 0 'stiction a.prm --output x' a.prm --output x
check 0 'ranks 2|stiction a.prm --output x' -n 2 a.prm --output x
check 0 'ranks 2|stiction a.prm --output x' a.prm --output x -n 2
check 0 "ranks 3|stiction a.prm|$picture" --picture a.prm -n 3
STATUS=2 check 2 "stiction a.prm|$picture" a.prm --picture
STATUS=1 check 1 'stiction a.prm' a.prm --picture
check 1 "run: -n must be followed by a number of ranks, not by ''" a.prm -n
check 1 "run: there is no parameter file 'b.prm'" b.prm -n 2
check 1 "run: '--output' is no command, './run --help' lists them" --output x
mkdir -p parameters/meshes
echo 'import sys; print("mesh of", *sys.argv[1:])' >parameters/meshes/step_to_msh.py
check 0 'mesh of a.step a.msh --size 5' mesh a.step a.msh --size 5
mkdir -p parameters/methods
printf '# A block. It is\n# red.\nsubsection A\n# no\n' >parameters/block.prm
printf '# A method, of\n# two lines: so.\n\n' >parameters/methods/m.prm
list=$(printf '%-52s %s' parameters/block.prm 'A block')
list+=$(printf '|%-52s %s' parameters/methods/m.prm 'A method, of two lines')
check 0 "$list" list
exit $((failures > 0))
