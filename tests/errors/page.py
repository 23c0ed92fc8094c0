#!/usr/bin/env python3
"""The page of bad inputs, from what the test run has seen.

Call:   page.py DIRECTORY [--write]

DIRECTORY is where the cases ran, build/tests/errors. Compares with doc/bad_inputs.md, of
the cases that ran, and exits with 1 if a message is another one, is missing, or belongs
to no case; --write makes the page from them.
"""

import glob
import os
import re
import sys

HERE = os.path.dirname(os.path.abspath(__file__))
PAGE = os.path.join(os.path.dirname(os.path.dirname(HERE)), "doc", "bad_inputs.md")
HEAD = """# Bad inputs, and what is said

Every case of bad input in the test suite, with the sentence that ends the run. The exit
status is 1, and unless the case says otherwise nothing is solved and results of an
earlier run are left as they are. The test run makes this page
(`tests/errors/page.py build/tests/errors --write`), and a test compares it with what is
said today. Sizes of memory depend on the machine and stand as `…`.
"""
SMALLEST_GROUP = 5


def cases():
    """Name and first line of each, where the status is 1; once for all ranks."""
    for path in sorted(glob.glob(os.path.join(HERE, "*.case"))):
        name = os.path.basename(path)[:-len(".case")]
        with open(path, encoding="utf-8", errors="replace") as file:
            text = file.read().partition("\nprm")[0]
        if "\nstatus: 1" in text and not re.search(r"_[23]_ranks$", name):
            yield name, " ".join(re.match(r"((?:#.*\n)+)", text)[1].split("\n# ")
                                 ).lstrip("# ").strip()


def said(directory, name):
    """The sentence of a case that ran, or nothing."""
    try:
        with open(os.path.join(directory, name, "stderr"), encoding="utf-8",
                  errors="replace") as file:
            text = file.read().strip()
    except FileNotFoundError:
        return None
    text = text[len("stiction: "):] if text.startswith("stiction: ") else text
    text = text.replace(os.path.realpath(os.path.join(directory, name, "run")), "…")
    return re.sub(r"[\d.e+]+ ([kMG]B)", r"… \1", text) or None


def cell(text):
    """As an entry of a table."""
    return re.sub(r"([|*_<\\`\[])", r"\\\1", text)


def rows(directory, known):
    """A row a case; of a case that did not run the one of the page."""
    for name, title in cases():
        message = said(directory, name)
        end = f" | {name} |"
        if message:
            yield name, f"| {cell(title)} | {cell(message)}{end}"
        elif end in known:
            yield name, known[end]


def page(all_rows):
    """The whole, by the first word of the names."""
    groups = {}
    for name, row in all_rows:
        groups.setdefault(name.partition("_")[0], []).append(row)
    small = [word for word, group in groups.items() if len(group) < SMALLEST_GROUP]
    groups["and others"] = [row for word in small for row in groups.pop(word)]
    return HEAD + "".join(
        f"\n## {word[0].upper() + word[1:]}\n\n| given | said | case |\n|---|---|---|\n" +
        "\n".join(group) + "\n" for word, group in groups.items())


def main():
    """Compare or write."""
    if len(sys.argv) < 2 or not os.path.isdir(sys.argv[1]):
        sys.exit(__doc__)
    directory = sys.argv[1]
    text = ""
    if os.path.exists(PAGE):
        with open(PAGE, encoding="utf-8") as file:
            text = file.read()
    known = {line[line.rfind(" | ", 0, -2):]: line for line in text.split("\n")
             if line.startswith("| ")}
    made = page(rows(directory, known))
    if "--write" in sys.argv:
        with open(PAGE, "w", encoding="utf-8") as file:
            file.write(made)
    elif made != text:
        wrong = set(made.split("\n")) ^ set(text.split("\n"))
        sys.exit("doc/bad_inputs.md is not what the program says, 'tests/errors/page.py "
                 "build/tests/errors --write' makes it anew:\n" + "\n".join(sorted(wrong)))


if __name__ == "__main__":
    main()
