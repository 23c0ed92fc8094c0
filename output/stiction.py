"""Run stiction from Python and read what a run wrote. Needs numpy alone.

    import sys; sys.path.insert(0, "output")
    import stiction

    run = stiction.run("parameters/brick.prm", {"Friction/Coefficient": 0.2})
    print(run.certified, run.summary["contact"]["force_on_body"])
    print(run.history["force_z"])        # columns of history.csv, of runs with steps
    nodes = run.contact()                # where contact forces act, once each
    print(nodes["points"][nodes["pressure"].argmax()])

'read(DIRECTORY)' is the same for a run that was made before. Whether a run is certified
is in it, and in 'message' why one that was made here is not; only what is no run at all,
such as a file that is missing, raises an Error.
"""

import base64
import csv
import json
import os
import shutil
import subprocess
import tempfile
import weakref
import zlib
from xml.etree import ElementTree

import numpy as np

PROGRAM = os.path.join(os.path.dirname(os.path.dirname(os.path.abspath(__file__))),
                       "build", "stiction")
if not os.path.exists(PROGRAM):
    PROGRAM = "stiction"  # this is an installed one
TYPES = {"Float32": "<f4", "Float64": "<f8", "Int32": "<i4", "UInt32": "<u4",
         "Int64": "<i8", "UInt64": "<u8", "UInt8": "u1", "Int8": "i1"}


class Error(Exception):
    """What is no run: one sentence."""


class Run:
    """What a run wrote into its directory.

    summary: summary.json as it is. history, convergence, energy: a numpy array a column
    of the files of these names, empty where there is no such file; columns of words are
    lists of these. certified, and if not, reason: why.
    """

    def __init__(self, directory, status=None, message=""):
        self.directory, self.status, self.message = directory, status, message
        try:
            with open(os.path.join(directory, "summary.json"), encoding="utf-8") as file:
                self.summary = json.load(file)
        except (OSError, ValueError) as error:
            raise Error(f"{directory} holds no run: {message or error}") from error
        self.certified = self.summary["converged"] and not self.summary.get("interrupted")
        self.reason = self.summary.get("reason")
        self.history = read_table(os.path.join(directory, "history.csv"))
        self.convergence = read_table(os.path.join(directory, "convergence.csv"))
        self.energy = read_table(os.path.join(directory, "energy.csv"))

    def contact(self, step=None, both_sides=False):
        """The fields at the nodes where contact forces act, of which the summary speaks:
        of a step, or at the end.

        both_sides: with the nodes opposite in pairs, whose pressures follow from these.
        """
        fields = once_each(self._fields("contact", step))
        known = [part["id"] for part in self.summary["contact"].get("boundaries", ())]
        shown = np.isin(fields["boundary"], known)
        if both_sides or not shown.any():
            return fields
        return {key: values[shown] for key, values in fields.items()}

    def solution(self, step=None):
        """Points, cells (rows of corners) and fields of the body: of a step, or at the
        end. Points stand once a cell."""
        return self._fields("solution", step)

    def _fields(self, name, step):
        tag = "" if step is None else f"_{step:04d}"
        if step is None and not os.path.exists(os.path.join(self.directory, name + ".pvtu")):
            tag = self._last_tag(name)
        return read_fields(os.path.join(self.directory, f"{name}{tag}.pvtu"))

    def _last_tag(self, name):
        """That of the end of a run with steps, be it certified or not."""
        if os.path.exists(os.path.join(self.directory, name + "_uncertified.pvtu")):
            return "_uncertified"
        series = os.path.join(self.directory, name + ".pvd")
        if not os.path.exists(series):
            raise Error(f"{self.directory} holds no fields '{name}'")
        files = [entry.get("file") for entry in ElementTree.parse(series).iter("DataSet")]
        return files[-1][len(name):-len(".pvtu")]


def run(parameters, settings=None, directory=None, ranks=1, program=None, restart=None):
    """Solve the problem of a parameter file, or of a text that is one.

    settings: {'Section/Entry': value} instead of what the file says; directory: where
    the files go, unless given one that goes when the run does; restart: the directory of
    a run from whose checkpoint this one goes on. A run that is not certified comes back
    all the same; one that was refused raises an Error.
    """
    if directory is None:
        directory = tempfile.mkdtemp(prefix="stiction_")
        try:
            result = run(parameters, settings, directory, ranks, program, restart)
        except Error:
            shutil.rmtree(directory)
            raise
        weakref.finalize(result, shutil.rmtree, directory, ignore_errors=True)
        return result
    options = ["--restart", os.fspath(restart)] if restart is not None else []
    end, message = _call(parameters, settings, directory, ranks, program, options)
    return Run(directory, end.returncode, message)


def validate(parameters, settings=None, ranks=1, program=None):
    """What is understood of a problem, in words; nothing is solved. One that run() would
    refuse before it solves anything raises an Error."""
    with tempfile.TemporaryDirectory(prefix="stiction_") as directory:
        return _call(parameters, settings, directory, ranks, program,
                     ["--validate"])[0].stdout


def _call(parameters, settings, directory, ranks, program, options):
    """How the program ended, and the sentence on that if it is not certified."""
    program = program or PROGRAM
    os.makedirs(directory, exist_ok=True)
    parameters = os.fspath(parameters)
    if "\n" in parameters:
        text, parameters = parameters, os.path.join(directory, "input.prm")
        with open(parameters, "w", encoding="utf-8") as file:
            file.write(text)
    command = [program, parameters, "--output", directory, *options]
    if ranks > 1:
        command = ["mpirun", "--quiet", "--oversubscribe", "-n", str(ranks)] + command
    for entry, value in (settings or {}).items():
        value = str(value).lower() if isinstance(value, bool) else value
        command += ["--set", f"{entry}={value}"]
    environment = {"OMP_NUM_THREADS": "1", "OPENBLAS_NUM_THREADS": "1", **os.environ}
    if os.geteuid() == 0:  # Open MPI refuses to run as root, even in a container
        environment.update(OMPI_ALLOW_RUN_AS_ROOT="1", OMPI_ALLOW_RUN_AS_ROOT_CONFIRM="1")
    try:
        end = subprocess.run(command, capture_output=True, text=True, check=False,
                             env=environment)
    except OSError as error:
        raise Error(f"cannot run '{program}': {error.strerror}") from error
    said = [line for line in (end.stderr + end.stdout).splitlines()
            if line.startswith(("stiction: ", "NOT CONVERGED: ", "INTERRUPTED: "))]
    message = said[0].split(": ", 1)[1] if said else ""
    if end.returncode not in (0, 2, 3):
        raise Error(message or f"'{program}' ended with status {end.returncode}")
    return end, message


def read(directory):
    """The run that wrote into a directory."""
    return Run(directory)


def read_table(name):
    """The columns of a CSV file by their names."""
    if not os.path.exists(name):
        return {}
    with open(name, newline="", encoding="utf-8") as file:
        rows = list(csv.DictReader(file))
    columns = {key: [row[key] for row in rows] for key in (rows[0] if rows else {})}
    for key, values in columns.items():
        try:
            columns[key] = np.array([float(value or "nan") for value in values])
        except ValueError:
            pass  # words
    return columns


def read_fields(name):
    """The points, the cells and the point data of all parts of a .pvtu file."""
    try:
        parts = [entry.get("Source") for entry in ElementTree.parse(name).iter("Piece")]
        pieces = [read_piece(os.path.join(os.path.dirname(name), part)) for part in parts]
    except (OSError, ElementTree.ParseError, ValueError, zlib.error) as error:
        raise Error(f"{name} cannot be read: {error}") from error
    first = np.cumsum([0] + [len(piece["points"]) for piece in pieces])
    for piece, offset in zip(pieces, first):
        piece["cells"] = piece["cells"] + offset
    return {key: np.concatenate([piece[key] for piece in pieces if len(piece["points"])]
                                or [pieces[0][key]]) for key in pieces[0]}


def read_piece(name):
    """One .vtu file."""
    grid = ElementTree.parse(name).getroot()
    blocks = grid.find(".//Points"), grid.find(".//Cells"), grid.find(".//PointData")
    fields = {"points": read_array(blocks[0].find("DataArray"))}
    cells = {array.get("Name"): read_array(array) for array in blocks[1]}
    n = len(cells["offsets"])
    fields["cells"] = cells["connectivity"].reshape(n, -1) if n else np.zeros((0, 4), int)
    if blocks[2] is not None:
        fields.update({array.get("Name"): read_array(array) for array in blocks[2]})
    return fields


def read_array(array):
    """The numbers of a DataArray: compressed blocks behind a header of their sizes."""
    kind, text = TYPES[array.get("type")], (array.text or "").strip()
    if array.get("format") == "ascii":
        numbers = np.array(text.split(), dtype=kind)
    else:
        n = int(np.frombuffer(base64.b64decode(text[:8])[:4], "<u4")[0]) if text else 0
        length = 4 * -(-4 * (3 + n) // 3)  # of the header, in base64
        sizes = np.frombuffer(base64.b64decode(text[:length]), "<u4")[3:]
        packed, data, start = base64.b64decode(text[length:]), b"", 0
        for size in sizes[:n]:
            data += zlib.decompress(packed[start:start + size])
            start += size
        numbers = np.frombuffer(data, kind)
    components = int(array.get("NumberOfComponents") or 1)
    return numbers.reshape(-1, components) if components > 1 else numbers


def once_each(fields):
    """Fields of which every node stands once, in place of once a face."""
    keys = np.column_stack([fields["points"], fields["boundary"]])
    _, first = np.unique(keys, axis=0, return_index=True)
    return {key: values[first] for key, values in fields.items() if key != "cells"}
