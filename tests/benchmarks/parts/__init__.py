"""The parts of the benchmarks: what is run, how, and what is made of it."""
