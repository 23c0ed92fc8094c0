"""README and the guide say what is so: links and files exist, the page of parameters is
the program's, every command runs, the part of README's own is certified, and doxygen has
no complaints.

Call: test_docs.py PROGRAM
"""

import fnmatch
import glob
import os
import re
import shlex
import shutil
import subprocess
import sys
import tempfile
import textwrap
import unittest

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
PROGRAM = os.path.abspath(sys.argv.pop(1))
PAGES = [os.path.join(ROOT, name) for name in ("README.md", "CONTRIBUTING.md")] + sorted(
    glob.glob(os.path.join(ROOT, "doc", "**", "*.md"), recursive=True))
sys.path[:0] = [os.path.join(ROOT, "doc"), os.path.join(ROOT, "tests", "verification")]
import parameters  # pylint: disable=wrong-import-position
from battery.mesh import cube  # pylint: disable=wrong-import-position


def read(page):
    """The text of a page."""
    with open(page, encoding="utf-8") as file:
        return file.read()


def commands(page):
    """The indented commands of a page, continued lines joined."""
    text = read(page).replace("\\\n", " ")
    return [shlex.split(line) for line in re.findall(
        r"^ {4,}((?:\./run|build/stiction) .*)$", text, re.MULTILINE)]


class Pages(unittest.TestCase):
    """What the pages say of the project."""

    def test_links(self):
        for page in PAGES:
            for link in re.findall(r"\]\(([^)]+)\)", read(page)):
                if "://" not in link:
                    path = link.partition("#")[0]
                    self.assertTrue(not path or os.path.exists(
                        os.path.join(os.path.dirname(page), path)), f"{page}: {link}")

    def test_files(self):
        for page in PAGES:
            for name in re.findall(r"`(?:\./)?((?:parameters|output|doc|source|tests)/[\w./]+?\."
                                   r"(?:prm|py|md|msh|cc|h))`", read(page)):
                if "NAME" not in name and (
                        not name.startswith("output/") or name.endswith(".py")):
                    self.assertTrue(os.path.exists(os.path.join(ROOT, name)),
                                    f"{page}: {name}")

    def test_anchors(self):
        for page in PAGES:
            for path, anchor in re.findall(r"\]\(([\w/.]*)#([\w-]+)\)", read(page)):
                there = os.path.join(os.path.dirname(page), path) if path else page
                titles = [re.sub(r"[^\w -]", "", title).strip().lower().replace(" ", "-")
                          for title in re.findall(r"^#+ (.*)$", read(there), re.MULTILINE)]
                self.assertIn(anchor, titles, page)

    def test_parameters(self):
        self.assertEqual(read(os.path.join(ROOT, "doc", "parameters.md")),
                         parameters.page(PROGRAM), "call doc/parameters.py PROGRAM")

    def test_version(self):
        said = [re.search(pattern, read(os.path.join(ROOT, name)), re.MULTILINE)[1]
                for name, pattern in (("CMakeLists.txt", r"^project\(stiction VERSION (\S+)"),
                                      ("CHANGELOG.md", r"^## ([\d.]+)"),
                                      ("CITATION.cff", r"^version: (.*)$"))]
        self.assertEqual(len(set(said)), 1, said)

    def test_cplusplus(self):
        page = read(os.path.join(ROOT, "doc", "cplusplus.md"))
        for name in ("CMakeLists.txt", "slide.cc"):  # the test 'install' runs them
            file = read(os.path.join(ROOT, "tests", "install", "example", name))
            self.assertIn("\n" + textwrap.indent(file, "    ") + "\n", page)

    def test_container_has_every_file(self):
        """A star of .containerignore stands for no slash; the last rule counts."""
        rules = read(os.path.join(ROOT, ".containerignore")).split()
        tracked = subprocess.run(["git", "-C", ROOT, "ls-files"], capture_output=True,
                                 text=True, check=False).stdout.split("\n")
        if len(tracked) < 2:
            self.skipTest("no files of git's here")
        for name in tracked:
            parts, kept = name.split("/"), True
            for rule in rules:
                pattern = rule.strip("!/").split("/")
                if len(pattern) <= len(parts) and all(map(fnmatch.fnmatch, parts, pattern)):
                    kept = rule.startswith("!")
            self.assertTrue(kept, name)

    def test_every_shipped_file_is_listed(self):
        listed = read(os.path.join(ROOT, "doc", "shipped_files.md"))
        for folder in ("", "several_bodies"):
            for name in glob.glob(os.path.join(ROOT, "parameters", folder, "*.prm")):
                self.assertIn(os.path.basename(name), listed)


@unittest.skipUnless(shutil.which("doxygen"), "doxygen is missing")
class Api(unittest.TestCase):
    """The pages of classes."""

    def complaints(self, *settings):
        """What doxygen says with these lines behind those of './run api'."""
        with tempfile.TemporaryDirectory() as directory:
            lines = [read(os.path.join(ROOT, "doc", "Doxyfile")),
                     "OUTPUT_DIRECTORY = " + directory, *settings]
            end = subprocess.run(["doxygen", "-"], input="\n".join(lines), cwd=ROOT,
                                 capture_output=True, text=True, check=False)
            self.assertTrue(os.path.exists(os.path.join(directory, "html", "index.html")))
        return end.stderr

    def test_no_warning(self):
        self.assertEqual(self.complaints(), "")

    def test_every_class_has_words(self):
        self.assertEqual(re.findall("Compound.*", self.complaints("EXTRACT_ALL = NO")), [])


class Commands(unittest.TestCase):
    """What the pages say to type."""

    def solve(self, arguments, directory, statuses=(0,)):
        """Runs the program in a directory that has the project's folders."""
        end = subprocess.run([PROGRAM, *arguments], cwd=directory, capture_output=True,
                             text=True, check=False)
        self.assertIn(end.returncode, statuses, f"{arguments}\n{end.stderr[-400:]}")

    def test_commands(self):
        words = re.findall(r"^  (\w+)\)$", read(os.path.join(ROOT, "run")), re.MULTILINE)
        done = set()
        with tempfile.TemporaryDirectory() as directory:
            os.symlink(os.path.join(ROOT, "parameters"),
                       os.path.join(directory, "parameters"))
            for page in PAGES:
                for command in commands(page):
                    if command[0] == "./run" and not command[1].endswith(".prm"):
                        self.assertIn(command[1], words, page)
                        continue
                    if not command[1].startswith(("parameters/", "--problem")) or (
                            "newton_multigrid" in command[1]):  # a million unknowns
                        continue
                    arguments = command[1:]
                    while "-n" in arguments:
                        del arguments[arguments.index("-n"):arguments.index("-n") + 2]
                    arguments = [word for word in arguments if word != "--picture"]
                    if str(arguments) in done:
                        continue
                    done.add(str(arguments))
                    # the history that friction ends is one of the tutorials
                    self.solve(arguments, directory,
                               (1, 2) if "Time/End=1" in arguments else (0,))
        self.assertGreater(len(done), 8)

    def test_own_part(self):
        text = read(os.path.join(ROOT, "README.md"))
        block = re.search(r"^ {7}subsection Geometry.*?(?=^\S|^\d)", text,
                          re.MULTILINE | re.DOTALL)[0]
        with tempfile.TemporaryDirectory() as directory:
            with open(os.path.join(directory, "part.prm"), "w", encoding="utf-8") as file:
                file.write(block)
            with open(os.path.join(directory, "part.msh"), "w", encoding="utf-8") as file:
                file.write(cube(4))
            self.solve(["part.prm", "--validate"], directory)
            self.solve(["part.prm"], directory)
            for name in ("solution.pvtu", "contact.pvtu"):
                self.assertTrue(os.path.exists(
                    os.path.join(directory, "output", "stiction", name)))

    def test_python(self):
        text = read(os.path.join(ROOT, "doc", "tutorials.md"))
        script = re.search(r"^    import sys$.*?\n\n(?=\S)", text, re.MULTILINE | re.DOTALL)[0]
        script = "\n".join(line[4:] for line in script.splitlines())
        self.assertIn("stiction.run(", script)
        script = script.replace("for F in (0.0, 0.1, 0.2, 0.3, 0.4)", "for F in (0.0, 0.3)")
        script = script.replace("stiction.run(", "solve(").replace(
            "import stiction\n", "import functools, stiction\n"
            f"solve = functools.partial(stiction.run, program={PROGRAM!r})\n")
        end = subprocess.run([sys.executable, "-c", script], cwd=ROOT, capture_output=True,
                             text=True, check=False)
        self.assertEqual(end.returncode, 0, end.stderr)
        self.assertEqual(len(end.stdout.splitlines()), 2)
        self.assertTrue(all(" True " in line for line in end.stdout.splitlines()))


if __name__ == "__main__":
    unittest.main()
