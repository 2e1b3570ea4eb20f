# SPDX-License-Identifier: MIT OR Apache-2.0
"""A disk that becomes full while a guide is downloaded: first there was room, then something else took it."""

import os
import re
import subprocess
import sys
import time

import boxmorph
import pytest
from boxmorph import guides
from hub_server import HubServer
from test_guides import ID, LARGE, TOTAL, check_whole, download, environment, get  # noqa: F401 (a fixture)

#: The room that a download wants to stay free, and what the tests add to it, in bytes.
RESERVE, ROOM = 50_000_000, TOTAL + 4_000_000


@pytest.fixture
def hub():
    with HubServer() as server:
        yield server


@pytest.fixture
def disk(tmp_path):
    """A small disk of the test's own."""
    folder = tmp_path / "disk"
    folder.mkdir()
    command = ["mount", "-t", "tmpfs", "-o", f"size={RESERVE + ROOM}", "none", str(folder)]
    try:
        run = subprocess.run(command, capture_output=True, text=True)
        refused = run.stderr.strip() if run.returncode else None
    except OSError as error:
        refused = str(error)
    if refused is not None:
        pytest.skip(f"a small disk cannot be mounted here ({refused})")
    yield folder
    subprocess.run(["umount", "-l", str(folder)], check=True)


def fill(path):
    """Take all the room that is left on a disk; return how much it was, in bytes."""
    taken = 0
    with open(path, "wb", buffering=0) as file:
        for size in (1 << 20, 1 << 12):
            try:
                while True:
                    taken += file.write(bytes(size))
            except OSError:
                pass
    return taken


def check_sentence(sentence, folder, reason):
    """It names the guides folder, how much is still to come, and what to do."""
    assert sentence.startswith(f"{folder} took no more ({reason}")
    said = re.search(r"; (\d+) MB are still to come\. Make room there and download again", sentence)
    assert said and 1 <= int(said[1]) <= -(-TOTAL // 1_000_000), sentence
    assert "Or name another guides folder" in sentence and "permissions" not in sentence


def test_a_disk_that_fills_up_on_the_way(disk, hub):
    root = disk / "guides"
    hub.rate = 1_000_000
    job = download(root, hub)
    job.start()
    while job.progress()["bytes"] < 300_000:
        time.sleep(0.01)
    fill(disk / "of another program")
    with pytest.raises(boxmorph.GuideError) as caught:
        job.join()
    check_sentence(str(caught.value), root, "No space left on device")
    # What has come stays, and is not offered as a guide.
    assert [path.name for path in root.iterdir() if not path.name.startswith(".")] == []
    here = guides.presence(ID, "fp32", root)
    assert here["state"] == "partial" and 300_000 <= here["bytes"] < TOTAL and here["total"] == TOTAL
    # While there is no room, nothing is asked for again.
    before = hub.paths("GET")
    with pytest.raises(boxmorph.GuideError, match=r"no room in .*guides: \d+ MB more are needed, 0 MB are"):
        get(root, hub)
    assert hub.paths("GET") == before
    (disk / "of another program").unlink()
    hub.rate = None
    before = len(hub.log)
    check_whole(get(root, hub))
    assert [span for *_, span in hub.log[before:] if span], "it began anew"


def test_a_disk_without_room_for_a_folder(disk, hub):
    # Room by its bytes, but none for one more file.
    subprocess.run(["mount", "-o", "remount,nr_inodes=2", str(disk)], check=True)
    (disk / "guides").mkdir()
    with pytest.raises(boxmorph.GuideError) as caught:
        get(disk / "guides", hub)
    assert "guides took no more (No space left on device" in str(caught.value)
    assert list((disk / "guides").iterdir()) == []


#: Downloads in a process whose files may have so many bytes.
LIMITED = """
import resource, sys
import boxmorph
from boxmorph import guides
job = guides.Download(*sys.argv[1:4], endpoint=sys.argv[4], pause=0.01)
resource.setrlimit(resource.RLIMIT_FSIZE, (int(sys.argv[5]), resource.RLIM_INFINITY))
job.start()
try:
    job.join()
except boxmorph.GuideError as error:
    print(error)
    print(guides.presence(*sys.argv[1:4])["bytes"])
"""


@pytest.mark.skipif(os.name != "posix", reason="only Unix limits the size of a process's files")
def test_a_disk_that_takes_no_large_files(tmp_path, hub):
    root, most = tmp_path / "guides", LARGE // 2
    command = [sys.executable, "-c", LIMITED, ID, "fp32", str(root), hub.url, str(most)]
    run = subprocess.run(command, capture_output=True, text=True, timeout=60, check=True)
    sentence, here = run.stdout.splitlines()
    check_sentence(sentence, root, "File too large")
    assert most <= int(here) < LARGE
    assert [path.name for path in root.iterdir() if not path.name.startswith(".")] == []
    check_whole(get(root, hub))
