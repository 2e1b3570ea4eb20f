# SPDX-License-Identifier: MIT OR Apache-2.0
# Guides that lie on the Hugging Face hub, and their download.
from os import PathLike
from pathlib import Path
from typing import Any, Literal

Precision = Literal["fp32", "fp16", "int8"]

def registry() -> list[dict[str, Any]]:
    """All guides that can be downloaded, in the order in which they are offered.

    id, title, repository, revision, licence, image_size (pixels), good_for, and precisions: by name, a dict
    of bytes (roughly), verified (whether independent sources agree on the names of its files), note,
    folder_name and files.
    """

def presence(id: str, precision: Precision, folder: str | PathLike[str]) -> dict[str, Any]:
    """How much of a guide is on this machine, without asking the network: in the folder of guides `folder`,
    or in the cache that other programs keep of the hub ($HF_HUB_CACHE, $HF_HOME, ~/.cache/huggingface/hub).

    state ("absent", "partial", "present" or "cached"), path (of the guide's folder, or None), bytes, total.
    Raises ValueError for a guide or precision that there is not.
    """

def remove(id: str, precision: Precision, folder: str | PathLike[str]) -> None:
    """Deletes a guide that was downloaded into `folder`, or what an unfinished download left there; no other
    files. Raises GuideError where that is not allowed.
    """

class Download:
    """A download on a thread of its own; not started when made. What came of an earlier one is gone on with.

    The guide appears in `folder` only when it is whole and each file has the hash that the hub announces. A
    guide that lies in the hub's cache is not downloaded.
    """

    def __init__(
        self,
        id: str,
        precision: Precision,
        folder: str | PathLike[str],  # the folder of guides; made if it does not exist
        *,
        endpoint: str | None = None,  # the hub's address; None: $HF_ENDPOINT, else https://huggingface.co
        timeout: float = 30.0,  # seconds for which a silent server is waited for
        pause: float = 1.0,  # seconds before something is tried again; doubles with each try
    ) -> None: ...
    def start(self) -> None: ...
    def progress(self) -> dict[str, Any]:
        """The download as it stands now.

        phase, file, bytes, total (0 until the server has said), seconds_left, trouble (why something is tried
        again, or ""), finished.
        """

    def cancel(self) -> None: ...
    def join(self) -> None:
        """Waits for the end. Raises Cancelled, GuideError, ValueError or RuntimeError."""

    def result(self) -> Path:
        """The guide's folder: the one made, or where the guide was all along. Raises what join() raises."""
