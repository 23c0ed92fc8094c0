"""Installs stiction, and lets the installed program and the example of doc/cplusplus.md,
compiled against the installed library, solve the same problem.

Call: test_install.py CMAKE BUILD_DIRECTORY [CMAKE OPTIONS of the example]
"""

import json
import os
import shlex
import subprocess
import sys
import tempfile

CMAKE, BUILD, *OPTIONS = sys.argv[1:]
BUILD = os.path.abspath(BUILD)
EXAMPLE = os.path.join(os.path.dirname(os.path.abspath(__file__)), "example")


def call(*command):
    """What a command says, which must succeed."""
    end = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                         cwd=directory, text=True, check=False)
    if end.returncode != 0:
        sys.exit(f"{' '.join(command)}\n{end.stdout}")
    return end.stdout


with tempfile.TemporaryDirectory() as directory:
    prefix = os.path.join(directory, "prefix")
    share = os.path.join(prefix, "share", "stiction")
    brick = os.path.join(share, "parameters", "brick.prm")
    call(CMAKE, "--install", BUILD, "--prefix", prefix)

    call(CMAKE, "-S", EXAMPLE, "-B", "example", f"-DCMAKE_PREFIX_PATH={prefix}", *OPTIONS)
    call(CMAKE, "--build", "example")
    said = call(os.path.join("example", "slide"), brick)
    assert "\nCERTIFIED: " in said, said
    of_example = json.loads(said.splitlines()[-1])

    os.environ["PATH"] = os.path.join(prefix, "bin") + os.pathsep + os.environ["PATH"]
    completion = os.path.join(prefix, "share", "bash-completion", "completions", "stiction")
    words = call("bash", "-c", f"""source {shlex.quote(completion)}
        COMP_WORDS=(stiction --set Friction/C) COMP_CWORD=2
        _stiction stiction
        echo "${{COMPREPLY[@]}}" """)
    assert words == "Friction/Coefficient=\n", words

    sys.path.insert(0, share)
    import stiction  # pylint: disable=wrong-import-position,import-error
    run = stiction.run(brick, {"Friction/Coefficient": 0.1}, os.path.join(directory, "run"))
    assert run.certified, run.message
    of_program = run.summary["contact"]["force_on_body"]

for one, other in zip(of_example, of_program):
    assert abs(one - other) <= 1e-9 * max(map(abs, of_program)), (of_example, of_program)
