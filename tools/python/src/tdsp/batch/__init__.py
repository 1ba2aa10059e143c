# SPDX-License-Identifier: MIT
"""Thousands of scenes, or of pairs of places in one scene, over the workers of a Dask cluster. Needs `pip install tdsp[batch]`.

    python -m tdsp.batch scenes FOLDER -o OUT --departures 0,60,120 --tables
    python -m tdsp.batch pairs SCENE --sources FILE --destinations FILE -o OUT --departures 0

A batch is cut into parts of a few items each. A part is done when its file in OUT/items is there, whole: workers write its tables first, then its
answers, then that file, each under a temporary name that is renamed. So whatever is killed, a worker or all of it, the same command goes on where it
stopped: what is done is never done again, and nothing is lost or there twice. A scene that is bad becomes a row that says why.

| in OUT | |
|---|---|
| `batch.json` | what was asked for |
| `answers/*.parquet` | a row for each question: `item`, `name`, `question`, `departure`, `arrival`, `status`, `error` |
| `items/*.parquet` | a row for each item: `item`, `name`, `status`, `error`, its table and what building it cost |
| `tables/PART/ITEM-NAME.tdsp` | the tables, where asked for |

In Python: make a `Plan`, `run` it with a `distributed.Client`, read `answers` and `items`.
"""
from __future__ import annotations

from .plan import Item, Plan, Questions, read_pairs, read_places, read_scenes
from .run import Outcome, answers, items, run

__all__ = ["Item", "Outcome", "Plan", "Questions", "answers", "items", "read_pairs", "read_places", "read_scenes", "run"]
