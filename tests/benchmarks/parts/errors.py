"""The one kind of error that ends a benchmark with a sentence."""


class BenchmarkError(Exception):
    """Something the user can put right; its text is the sentence."""
