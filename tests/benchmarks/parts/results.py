"""The figures of all runs, as one flat table that reports are made from."""

from . import cases, figures, runs

SKIPPED = "skipped"
NOT_RUN = "not run"

# Names in table_1.csv and where the figure stands in summary.json.
FROM_SUMMARY = {
    "cells": "problem/cells",
    "nodes": "problem/nodes",
    "dofs": "problem/dofs",
    "contact_nodes": "problem/contact_nodes",
    "dual_unknowns": "problem/dual_unknowns",
    "program_s": "seconds/total",
    "contact_solve_s": "seconds/contact_solve",
    "dual_operator_s": "seconds/dual_operator",
    "stiffness_setup_s": "seconds/stiffness_setup",
    "dense_cholesky_s": "seconds/dual_cholesky",
    "sparse_factorization_s": "seconds/sparse_factorization",
    "products": "solver/dual_multiplications",
    "newton_steps": "solver/newton_steps",
    "gauss_seidel_iterations": "solver/gauss_seidel_iterations",
    "coulomb_iterations": "solver/coulomb_iterations",
    "open": "contact/open",
    "slip": "contact/slip",
    "stick": "contact/stick",
    "kkt_residual": "certificate/kkt_residual",
    "duality_gap": "certificate/duality_gap",
}
FROM_RUN = {
    "exit_status": "exit_status",
    "wall_s": "wall",
    "cpu_s": "cpu",
    "memory_MB": "memory_MB",
    "tolerance": "tolerance",
    "threads": "threads",
    "limit_s": "limit",
    "date": "date",
    "program": "program",
    "message": "message",
}
COLUMNS = (
    ["k", "n", "m", "reading", "law", "method", "status", "exit_status"]
    + ["cells", "nodes", "dofs", "contact_nodes", "dual_unknowns"]
    + ["wall_s", "cpu_s", "program_s", "iteration_s", "contact_solve_s"]
    + ["dual_operator_s", "stiffness_setup_s"]
    + ["dense_cholesky_s", "sparse_factorization_s"]
    + ["products", "products_to_1e-6", "newton_steps"]
    + ["gauss_seidel_iterations", "coulomb_iterations", "memory_MB"]
    + ["open", "slip", "stick", "kkt_residual", "duality_gap"]
    + ["force_x", "force_y", "force_z", "force_reference", "force_difference"]
    + ["tolerance", "threads", "limit_s", "date", "program", "message"]
)


class Results:
    """All chosen cases with their figures.

    rows: {case: stored run}. A case without one is 'skipped' if a smaller k
    of its series was over the time limit, else 'not run'.
    """

    def __init__(self, chosen, rows):
        self.rows = rows
        self.entries = {case: self._entry(case) for case in chosen}
        for case, entry in self.entries.items():
            self._compare_force(case, entry)

    def _entry(self, case):
        row = self.rows.get(case, {})
        summary = row.get("summary")
        entry = dict.fromkeys(COLUMNS)
        entry.update(
            k=case.k,
            n=cases.table_n(case.k),
            m=cases.table_m(case.k),
            reading=case.reading,
            law=case.law,
            method=case.method,
            status=row.get("status") or self._why_missing(case),
            iteration_s=figures.iteration_seconds(summary),
        )
        entry.update({name: row.get(key) for name, key in FROM_RUN.items()})
        for name, path in FROM_SUMMARY.items():
            entry[name] = figures.look_up(summary, path)
        entry["products_to_1e-6"] = figures.products_to(row.get("history", []), 1e-6)
        entry["force"] = figures.look_up(summary, "contact/force_on_body")
        if entry["force"]:
            entry["force_x"], entry["force_y"], entry["force_z"] = entry["force"]
        entry["history"] = row.get("history", [])
        entry["solved"] = self._is_solved(case, entry)
        return entry

    def _why_missing(self, case):
        slow = any(
            other.series == case.series
            and other.k < case.k
            and row["status"] == runs.LIMIT
            for other, row in self.rows.items()
        )
        return SKIPPED if slow else NOT_RUN

    @staticmethod
    def _is_solved(case, entry):
        """Whether the method reached its own aim.

        The certificate is that of the disc and refuses what is exact on a
        polygon. There only the message tells whether the iteration ended by
        itself or asks for more iterations.
        """
        if entry["status"] == runs.CERTIFIED:
            return True
        return (
            cases.METHOD[case.method].kind == "polygon"
            and entry["status"] == runs.NOT_CERTIFIED
            and "Maximum iterations" not in entry["message"]
        )

    def _compare_force(self, case, entry):
        for method in cases.REFERENCE_METHODS:
            reference = self.get(case.k, case.reading, case.law, method)
            if reference and reference["status"] == runs.CERTIFIED:
                entry["force_reference"] = method
                entry["force_difference"] = figures.relative_difference(
                    entry["force"], reference["force"]
                )
                return

    def get(self, k, reading, law, method):
        """The figures of a case, None if it was not chosen."""
        return self.entries.get(cases.Case(k, reading, law, method))

    def cost(self, k, reading, law, method, figure):
        """A figure of a case that reached its aim, else None."""
        entry = self.get(k, reading, law, method)
        return entry[figure] if entry and entry["solved"] else None

    def chosen(self, part):
        """The different values of 'k', 'reading' or 'law', in order."""
        return sorted(
            {entry[part] for entry in self.entries.values()},
            key=lambda value: list(cases.LAWS).index(value)
            if part == "law"
            else value,
        )

    def methods(self, law, kinds=("disc", "polygon"), reading=None):
        """Names of the methods for this law that ran at all."""
        ran = {
            entry["method"]
            for entry in self.entries.values()
            if entry["law"] == law
            and reading in (None, entry["reading"])
            and entry["status"]
            in (runs.CERTIFIED, runs.NOT_CERTIFIED, runs.LIMIT)
        }
        return [
            method.name
            for method in cases.METHODS
            if method.name in ran and method.kind in kinds
        ]

    def newest_row(self):
        """The run made last, which says where and how."""
        return max(self.rows.values(), key=lambda row: row["date"])
