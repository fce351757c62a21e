# SPDX-License-Identifier: MIT
"""Many designs from one, on a machine or on a Dask cluster."""

from __future__ import annotations

import functools
import hashlib
import json
import os
from collections.abc import Callable, Iterator
from typing import TYPE_CHECKING, Any

from . import _core
from .request import request

if TYPE_CHECKING:
    from distributed import Client


class Job:
    """One design of a plan."""

    def __init__(self, plan: Plan, index: int) -> None:
        self.plan, self.index = plan, index
        self.id: str = plan._core.job_id(index)

    @property
    def values(self) -> dict[str, Any]:
        """The fields that the plan varies, with their values here."""
        return json.loads(self.plan._core.job_values(self.index))

    def run(
        self,
        folder: str | os.PathLike[str],
        *,
        count_types: float | str | None = None,
        mirrored: bool | None = None,
    ) -> dict[str, Any]:
        """Does it, unless `folder` has it, and gives its figures.

        Args:
            count_types, mirrored: as `edit` takes them.

        Raises:
            UsageError: an option that cannot be.
        """
        folder = os.fspath(folder)
        asked = request({"count_types": count_types, "mirrored": mirrored})
        if not self.is_done(folder):
            _core.save_job(folder, self.id, *self.plan._core.run(self.index, asked))
        with open(os.path.join(folder, self.id + ".json"), encoding="utf-8") as file:
            return json.load(file)

    def is_done(self, folder: str | os.PathLike[str]) -> bool:
        return os.path.exists(os.path.join(os.fspath(folder), self.id + ".json"))


class Plan:
    """A design and lists of values for some of its fields.

    Args:
        plan: JSON, or the same as a dict; docs/scale.md says what stands in it.

    Raises:
        UsageError: what is wrong with the plan, naming the field.
    """

    def __init__(self, plan: str | dict[str, Any]) -> None:
        self.text = plan if isinstance(plan, str) else json.dumps(plan)
        self._core = _core.Plan(self.text)

    @classmethod
    def load(cls, path: str | os.PathLike[str]) -> Plan:
        with open(path, encoding="utf-8") as file:
            return cls(file.read())

    def __len__(self) -> int:
        return len(self._core)

    def __getitem__(self, index: int) -> Job:
        return Job(self, range(len(self))[index])

    def __iter__(self) -> Iterator[Job]:
        return (Job(self, index) for index in range(len(self)))


def sweep(
    plan: Plan | str | dict[str, Any],
    client: Client,
    folder: str | os.PathLike[str],
    *,
    count_types: float | str | None = None,
    mirrored: bool | None = None,
    progress: Callable[[int, int, dict[str, Any]], bool | None] | None = None,
    retries: int = 3,
) -> None:
    """Does every job of `plan` on a Dask cluster; what `folder` has already is not done again.

    Results come to this process and are written here, so that workers need no common disk. A job
    whose worker is lost runs on another.

    Args:
        client: of dask.distributed; its workers need this package.
        folder: as `planish sweep -o` fills it; `gather` makes its table.
        count_types, mirrored: as `edit` takes them; the table then has both counts.
        progress: (done, all, figures), after every job; False cancels the rest.
        retries: how often a job that failed is tried again.
    """
    from distributed import as_completed

    plan = plan if isinstance(plan, Plan) else Plan(plan)
    folder = os.fspath(folder)
    waiting = {job.id: job for job in plan if not job.is_done(folder)}
    done, total = 0, len(waiting)
    # A task like the others: it is done again if the worker that holds it is lost.
    key = "planish-plan-" + hashlib.sha256(plan.text.encode()).hexdigest()
    text = client.submit(str, plan.text, key=key, retries=retries)
    asked = request({"count_types": count_types, "mirrored": mirrored})
    indices = [job.index for job in waiting.values()]
    keys = ["planish-job-" + name for name in waiting]
    futures = client.map(_run, indices, plan_text=text, asked=asked, key=keys, retries=retries)
    names = dict(zip(futures, waiting))
    for future in as_completed(futures):
        result = future.result()
        _core.save_job(folder, names[future], *result)
        future.release()
        done += 1
        if progress is not None and progress(done, total, json.loads(result[0])) is False:
            client.cancel(futures)
            return


def gather(folder: str | os.PathLike[str], path: str | os.PathLike[str]) -> None:
    """The table of a sweep as CSV, sorted by id: the same bytes wherever the jobs ran."""
    _core.gather(os.fspath(folder), os.fspath(path))


@functools.lru_cache(maxsize=4)
def _plan(text: str) -> _core.Plan:
    return _core.Plan(text)


def _run(index: int, plan_text: str, asked: str) -> tuple[str, str, str]:
    """On a worker, which reads a plan once."""
    return _plan(plan_text).run(index, asked)
