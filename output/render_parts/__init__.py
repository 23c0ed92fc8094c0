"""What output/render.py is made of, from the files of a run to its picture."""


class Unusable(Exception):
    """The sentence that says why there is no picture."""
