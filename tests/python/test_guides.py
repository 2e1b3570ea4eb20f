# SPDX-License-Identifier: MIT OR Apache-2.0
"""Guides from the hub: the registry, and downloads from a server on this machine that fails in every way."""

import json
import os
import re
import socket
import ssl
import subprocess
import sys
import threading
import time

import boxmorph
import pytest
from boxmorph import guides
from hub_server import COMMIT, MINI, HubServer

ID = "clip-vit-base-patch32"
FOLDER = f"{ID}-fp32"
LARGE = (MINI / "vision_model.onnx").stat().st_size
FILES = ("config.json", "preprocessor_config.json", "tokenizer.json")
TOTAL = sum((MINI / name).stat().st_size for name in (*FILES, "vision_model.onnx", "text_model.onnx"))
VARIABLES = ("HTTP_PROXY", "HTTPS_PROXY", "ALL_PROXY", "NO_PROXY", "HF_ENDPOINT", "HF_HUB_CACHE")


@pytest.fixture(autouse=True)
def environment(tmp_path, monkeypatch):
    """No proxy, no mirror, and an empty cache of the hub."""
    for name in VARIABLES:
        monkeypatch.delenv(name, raising=False)
        monkeypatch.delenv(name.lower(), raising=False)
    monkeypatch.setenv("HF_HOME", str(tmp_path / "hf"))


@pytest.fixture
def hub():
    with HubServer() as server:
        yield server


@pytest.fixture
def root(tmp_path):
    return tmp_path / "guides"


def download(root, hub, precision="fp32", **options):
    options = {"endpoint": hub if isinstance(hub, str) else hub.url, "pause": 0.01, **options}
    return guides.Download(ID, precision, root, **options)


def get(root, hub, **options):
    """Download, and return the guide's folder."""
    job = download(root, hub, **options)
    job.start()
    job.join()
    return job.result()


def refusal(root, hub, error=boxmorph.GuideError, **options):
    """Return the sentence with which a download ends; nothing may be offered as a guide then."""
    with pytest.raises(error) as caught:
        get(root, hub, **options)
    assert not root.exists() or [p.name for p in root.iterdir() if not p.name.startswith(".")] == []
    sentence = str(caught.value)
    assert (sentence[0].islower() or sentence[0] in '"/1') and "\n" not in sentence
    return sentence


def check_whole(folder):
    """The guide is there to the byte, and nothing else is."""
    for name in (*FILES, "onnx/vision_model.onnx", "onnx/text_model.onnx"):
        assert (folder / name).read_bytes() == (MINI / name.rpartition("/")[2]).read_bytes(), name
    found = {p.relative_to(folder).as_posix() for p in folder.rglob("*") if p.is_file()}
    assert found == {*FILES, "onnx/vision_model.onnx", "onnx/text_model.onnx", "boxmorph.json"}
    assert [p.name for p in folder.parent.iterdir()] == [folder.name]


def test_the_registry_is_sound():
    entries = guides.registry()
    assert {entry["id"] for entry in entries} >= {ID, "clip-vit-base-patch16", "clip-vit-large-patch14"}
    assert len({entry["id"] for entry in entries}) == len(entries) >= 6
    for entry in entries:
        assert re.fullmatch(r"[a-z0-9.-]+", entry["id"]) and not entry["id"].startswith(".")
        assert re.fullmatch(r"[\w-]+/[\w.-]+", entry["repository"])
        assert entry["revision"] == "main" or re.fullmatch("[0-9a-f]{40}", entry["revision"])
        assert entry["title"] and entry["licence"] and 0 < len(entry["good_for"]) < 90
        assert 64 <= entry["image_size"] <= 512
        assert list(entry["precisions"]) and set(entry["precisions"]) <= {"fp32", "fp16", "int8"}
        for name, precision in entry["precisions"].items():
            assert precision["folder_name"] == f"{entry['id']}-{name}"
            assert isinstance(precision["verified"], bool)
            assert 1e7 < precision["bytes"] < 3e9
            files = precision["files"]
            assert {"config.json", "preprocessor_config.json", "tokenizer.json"} <= set(files)
            for file in files:
                assert re.fullmatch(r"(onnx/)?[a-z0-9_]+\.(json|onnx|onnx_data)", file), file


def test_a_downloaded_guide_is_whole_and_opens(root, hub):
    folder = get(root, hub)
    assert folder == root / FOLDER
    check_whole(folder)
    assert boxmorph.Guide.open(folder).sha256 == boxmorph.Guide.open().sha256
    record = json.loads((folder / "boxmorph.json").read_text())
    assert (record["guide"], record["precision"], record["licence"]) == (ID, "fp32", "MIT")
    assert re.fullmatch("[0-9a-f]{40}", record["revision"])
    assert {file["name"] for file in record["files"]} >= set(FILES)


def test_only_files_of_the_registry_are_asked_for(root, hub):
    get(root, hub)
    (entry,) = (entry for entry in guides.registry() if entry["id"] == ID)
    asked = {re.sub(r".*/resolve/[0-9a-f]{40}/", "", path) for path in hub.paths("HEAD", "/resolve/")}
    assert asked == set(entry["precisions"]["fp32"]["files"])
    assert all(entry["repository"] in path for path in hub.paths(part="/resolve/"))


def test_a_branch_is_one_commit_from_the_first_answer_on(root, hub):
    job = guides.Download("clip-vit-base-patch16", "fp32", root, endpoint=hub.url)
    job.start()
    job.join()
    asked = hub.paths("HEAD", "/resolve/") + hub.paths(part="/resolve/")
    assert "/resolve/main/" in asked[0]
    assert all(f"/resolve/{COMMIT}/" in path for path in asked[1:])


def test_progress_counts_bytes(root, hub):
    hub.rate = 4_000_000
    job = download(root, hub)
    assert job.progress()["bytes"] == 0 and not job.progress()["finished"]
    job.start()
    seen = []
    while not job.progress()["finished"]:
        seen.append(job.progress())
        time.sleep(0.02)
    job.join()
    counts = [progress["bytes"] for progress in seen]
    assert counts == sorted(counts) and len(set(counts)) > 5
    assert {progress["total"] for progress in seen} == {0, TOTAL}
    assert {"onnx/vision_model.onnx", "onnx/text_model.onnx"} <= {progress["file"] for progress in seen}
    assert job.progress()["bytes"] == TOTAL
    assert job.progress()["phase"] == "Downloading"


def test_it_goes_on_after_cut_connections(root, hub):
    hub.cuts = [1_000_000, 500_000, 100_000]
    check_whole(get(root, hub))
    ranges = [span for verb, path, span in hub.log if verb == "GET" and "/cdn/onnx/vision" in path]
    assert ranges == [None, "bytes=1000000-", "bytes=1500000-", "bytes=1600000-"]


def test_a_line_that_is_always_cut_is_given_up(root, hub):
    hub.cuts = [1_000_000] + [0] * 20
    sentence = refusal(root, hub)
    assert "the connection to localhost broke off" in sentence and "try again" in sentence
    assert guides.presence(ID, "fp32", root)["state"] == "partial"
    hub.cuts = []
    check_whole(get(root, hub))


def test_a_server_without_ranges_is_read_from_the_start(root, hub):
    hub.knows_ranges, hub.cuts = False, [1_000_000]
    job = download(root, hub)
    job.start()
    job.join()
    check_whole(job.result())
    assert job.progress()["bytes"] == TOTAL
    # But not for ever.
    guides.remove(ID, "fp32", root)
    hub.cuts = [1_000_000] * 20
    assert "broke off" in refusal(root, hub)
    assert len(hub.cuts) > 10


def test_cancelling_keeps_what_has_come(root, hub):
    hub.rate = 1_000_000
    job = download(root, hub)
    job.start()
    while job.progress()["bytes"] < 300_000:
        time.sleep(0.01)
    begin = time.monotonic()
    job.cancel()
    with pytest.raises(boxmorph.Cancelled, match="what has come is kept"):
        job.join()
    assert time.monotonic() - begin < 5
    presence = guides.presence(ID, "fp32", root)
    assert presence["state"] == "partial" and presence["total"] == TOTAL
    assert 300_000 <= presence["bytes"] < TOTAL
    hub.rate = None
    job = download(root, hub)
    job.start()
    job.join()
    check_whole(job.result())
    assert job.progress()["bytes"] == TOTAL
    assert [span for *_, span in hub.log if span], "it began anew"


def test_a_silent_server_can_be_cancelled(root, hub):
    hub.silent = "/cdn/"
    job = download(root, hub, timeout=60.0)
    job.start()
    while not hub.paths(part="/cdn/"):
        time.sleep(0.01)
    begin = time.monotonic()
    job.cancel()
    with pytest.raises(boxmorph.Cancelled):
        job.join()
    assert time.monotonic() - begin < 5


def test_another_process_goes_on(root, hub):
    hub.rate = 1_000_000
    code = (
        "import sys, time; from boxmorph import guides\n"
        "job = guides.Download(*sys.argv[1:4], endpoint=sys.argv[4]); job.start()\n"
        "while job.progress()['bytes'] < 500_000: time.sleep(0.01)\n"
        "import os; os._exit(9)"
    )
    command = [sys.executable, "-c", code, ID, "fp32", str(root), hub.url]
    assert subprocess.run(command, timeout=60).returncode == 9
    here = guides.presence(ID, "fp32", root)["bytes"]
    assert here >= 500_000
    hub.rate = None
    before = len(hub.log)
    check_whole(get(root, hub))
    (span,) = {span for *_, span in hub.log[before:] if span}
    assert int(span[6:-1]) > 400_000


def test_two_at_once_do_not_meet(root, hub):
    hub.rate = 500_000
    first = download(root, hub)
    first.start()
    while first.progress()["bytes"] < 100_000:
        time.sleep(0.01)
    with pytest.raises(boxmorph.GuideError, match="another Blender downloads this guide"):
        get(root, hub)
    hub.rate = None
    first.join()
    check_whole(first.result())


def test_a_damaged_part_is_fetched_again(root, hub):
    hub.cuts = [1_000_000] + [0] * 20
    refusal(root, hub)
    (part,) = root.rglob("*.part")
    part.write_bytes(b"x" * 1_000_000)
    hub.cuts = []
    check_whole(get(root, hub))


def test_a_part_of_another_file_is_not_gone_on_with(root, hub):
    hub.cuts = [1_000_000] + [0] * 20
    refusal(root, hub)
    (part,) = root.rglob("*.part")
    part.rename(part.with_name("vision_model.onnx.0123456789abcdef.part"))
    hub.cuts = []
    before = len(hub.log)
    check_whole(get(root, hub))
    assert not any(span for *_, span in hub.log[before:])


@pytest.mark.parametrize("part", ["/cdn/onnx/text_model.onnx", "/resolve-cache/tokenizer.json"])
def test_another_content_is_refused(root, hub, part):
    data = (MINI / part.rpartition("/")[2]).read_bytes()
    hub.swapped = {part: data[:-1] + bytes([data[-1] ^ 1])}
    if "tokenizer" in part:
        # Announced as it is in truth, sent otherwise.
        hub.headers = {part: {"ETag": '"c8a2d0bf48b54bd2eb38ac1a5d6ee13e8eb4ee3c"'}}
    assert "arrived damaged" in refusal(root, hub)
    assert not list(root.rglob("*.part"))


@pytest.mark.parametrize("length", [LARGE - 1, LARGE + 5])
def test_another_length_is_refused(root, hub, length):
    data = (MINI / "vision_model.onnx").read_bytes() + b"more!"
    hub.swapped = {"/cdn/onnx/vision_model.onnx": data[:length]}
    sentence = refusal(root, hub)
    assert "arrived damaged" in sentence and not list(root.rglob("*.part"))


def test_a_file_that_is_known_is_not_taken_otherwise(root, hub):
    # The registry knows the hash of int8; the server's is another.
    assert "another onnx/vision_model_quantized.onnx than the one that is known" in refusal(
        root, hub, precision="int8"
    )
    assert not hub.paths("GET")


def test_a_server_that_names_no_hash_is_refused(root, hub):
    hub.headers = {"/resolve-cache/config.json": {"ETag": '"7"'}}
    assert "names no hash of config.json" in refusal(root, hub)


@pytest.mark.parametrize(
    ("status", "sentence"),
    [
        (401, "to members only (status 401)"),
        (403, "to members only (status 403)"),
        (404, "has no onnx/vision_model.onnx in Xenova/clip-vit-base-patch32"),
        (418, "status 418"),
    ],
)
def test_a_refusal_of_the_server_is_a_sentence(root, hub, status, sentence):
    hub.statuses = {"/onnx/vision_model.onnx": [status] * 9}
    assert sentence in refusal(root, hub)
    assert len(hub.statuses["/onnx/vision_model.onnx"]) == 8, "tried again in vain"


def test_an_optional_file_may_be_missing(root, hub):
    get(root, hub)
    assert any("tokenizer_config.json" in path for path in hub.paths("HEAD"))


def test_a_server_out_of_order_is_tried_again(root, hub):
    hub.statuses = {"/resolve/": [500, 502], "/cdn/": [503, 503]}
    check_whole(get(root, hub))
    hub.statuses = {"/resolve/": [500] * 9}
    guides.remove(ID, "fp32", root)
    assert "out of order (status 500)" in refusal(root, hub)
    assert len(hub.statuses["/resolve/"]) == 5


def test_the_server_says_how_long_to_wait(root, hub):
    hub.statuses, hub.retry_after = {"/cdn/": [429]}, 1
    job = download(root, hub)
    begin = time.monotonic()
    job.start()
    seen = set()
    while not job.progress()["finished"]:
        seen.add(job.progress()["trouble"])
        time.sleep(0.02)
    job.join()
    assert time.monotonic() - begin >= 1
    assert any("no more requests for now" in trouble for trouble in seen)
    guides.remove(ID, "fp32", root)
    hub.statuses, hub.retry_after = {"/cdn/": [429] * 9}, 600
    assert "try again in 10 min" in refusal(root, hub)
    assert len(hub.statuses["/cdn/"]) == 8


def test_silence_is_a_sentence(root, hub):
    hub.silent = "/cdn/"
    assert "localhost was silent for 0.3 s" in refusal(root, hub, timeout=0.3)


def test_a_redirect_loop_is_a_sentence(root, hub):
    hub.redirects = {"/resolve/": "/resolve/again"}
    assert "redirects without end" in refusal(root, hub)


def test_a_redirect_out_of_the_encrypted_is_not_followed(root, hub):
    hub.redirects = {"/cdn/": "http://hub.example/x"}
    assert "redirects to hub.example, which is not encrypted" in refusal(root, hub)


def test_no_network_is_a_sentence(root):
    with socket.socket() as unused:
        unused.bind(("127.0.0.1", 0))
        url = f"http://127.0.0.1:{unused.getsockname()[1]}"
        assert "no connection to 127.0.0.1" in refusal(root, url)
    assert "the name hub.invalid cannot be resolved" in refusal(root, "https://hub.invalid")
    assert not any(root.iterdir()), "an empty folder is left behind"


@pytest.mark.parametrize("address", ["http://hub.example", "hub.example", "https://u:p@hub.example"])
def test_an_address_that_is_none_is_refused(root, address):
    assert "is no address of a hub" in refusal(root, address, ValueError)


def test_a_full_disk_is_said_before_anything_comes(root, hub):
    hub.headers = {"/resolve/": {"X-Linked-Size": str(10**15)}}
    sentence = refusal(root, hub)
    assert re.search(r"no room in .*guides: 5\d{9} MB more are needed, \d+ MB are free", sentence)
    assert not hub.paths("GET")


@pytest.mark.skipif(os.name != "posix" or not hasattr(os, "geteuid"), reason="needs a Unix")
def test_a_folder_that_takes_no_files_is_a_sentence(tmp_path, hub):
    (tmp_path / "file").write_text("")
    assert "cannot be written" in str(refusal(tmp_path / "file" / "guides", hub))
    if os.geteuid() != 0:
        root = tmp_path / "guides"
        root.mkdir(mode=0o500)
        assert "cannot be written" in refusal(root, hub)


def test_a_folder_of_the_users_own_is_left_alone(root, hub):
    (root / FOLDER).mkdir(parents=True)
    (root / FOLDER / "mine.txt").write_text("mine")
    with pytest.raises(boxmorph.GuideError, match="was not made by a download"):
        get(root, hub)
    assert (root / FOLDER / "mine.txt").read_text() == "mine"


def test_a_guide_that_is_there_is_not_downloaded_again(root, hub):
    folder = get(root, hub)
    assert guides.presence(ID, "fp32", root)["state"] == "present"
    before = len(hub.log)
    assert get(root, hub) == folder and len(hub.log) == before


def test_removing_leaves_other_files(root, hub):
    folder = get(root, hub)
    (folder / "notes.txt").write_text("mine")
    guides.remove(ID, "fp32", root)
    assert [p.name for p in folder.rglob("*")] == ["notes.txt"]
    (folder / "notes.txt").unlink()
    folder.rmdir()
    get(root, hub)
    guides.remove(ID, "fp32", root)
    assert list(root.iterdir()) == []
    assert guides.presence(ID, "fp32", root)["state"] == "absent"


def test_what_is_unfinished_can_be_removed(root, hub):
    hub.cuts = [1_000_000] + [0] * 20
    refusal(root, hub)
    guides.remove(ID, "fp32", root)
    assert list(root.iterdir()) == []


@pytest.mark.parametrize("variable", ["HF_HOME", "HF_HUB_CACHE", "XDG_CACHE_HOME"])
def test_the_cache_of_the_hub_is_used_in_place(root, hub, tmp_path, monkeypatch, variable):
    monkeypatch.delenv("HF_HOME")
    monkeypatch.setenv(variable, str(tmp_path / "c"))
    below = {"HF_HOME": "hub", "HF_HUB_CACHE": "", "XDG_CACHE_HOME": "huggingface/hub"}[variable]
    repository = tmp_path / "c" / below / "models--Xenova--clip-vit-base-patch32"
    blobs, snapshot = repository / "blobs", repository / "snapshots" / COMMIT
    (snapshot / "onnx").mkdir(parents=True)
    blobs.mkdir()
    names = (*FILES, "onnx/vision_model.onnx", "onnx/text_model.onnx")
    for number, name in enumerate(names):
        (blobs / str(number)).write_bytes((MINI / name.rpartition("/")[2]).read_bytes())
        (snapshot / name).symlink_to(blobs / str(number))
    assert guides.presence(ID, "fp32", root) == {
        **guides.presence(ID, "fp32", root),
        "state": "cached",
        "path": snapshot,
    }
    assert guides.presence(ID, "fp16", root)["state"] == "absent"
    assert get(root, hub) == snapshot
    assert hub.log == [] and not root.exists()
    assert boxmorph.Guide.open(snapshot).image_size == 64
    (blobs / "4").unlink()
    assert guides.presence(ID, "fp32", root)["state"] == "absent"


def test_the_environment_names_the_hub(root, hub, monkeypatch):
    monkeypatch.setenv("HF_ENDPOINT", hub.url + "/")
    job = guides.Download(ID, "fp32", root)
    job.start()
    job.join()
    check_whole(job.result())


class Proxy(threading.Thread):
    """A proxy that tunnels, and notes to where."""

    def __init__(self, status=b"200 Connection established"):
        super().__init__(daemon=True)
        self.status, self.targets = status, []
        self.listener = socket.create_server(("127.0.0.1", 0))
        self.url = f"http://127.0.0.1:{self.listener.getsockname()[1]}"
        self.start()

    def run(self):
        while True:
            client, _ = self.listener.accept()
            threading.Thread(target=self.tunnel, args=(client,), daemon=True).start()

    def tunnel(self, client):
        request = b""
        while not request.endswith(b"\r\n\r\n"):
            request += client.recv(4096)
        verb, target, _ = request.split(b" ", 2)
        assert verb == b"CONNECT"
        self.targets.append(target.decode())
        client.sendall(b"HTTP/1.1 " + self.status + b"\r\n\r\n")
        if not self.status.startswith(b"200"):
            return client.close()
        host, _, port = target.decode().rpartition(":")
        server = socket.create_connection((host, int(port)))
        for source, sink in ((client, server), (server, client)):
            threading.Thread(target=self.pump, args=(source, sink), daemon=True).start()

    def pump(self, source, sink):
        try:
            while data := source.recv(1 << 16):
                sink.sendall(data)
            sink.shutdown(socket.SHUT_WR)
        except OSError:
            pass


def test_proxies_are_used_and_spared(root, hub, monkeypatch):
    proxy = Proxy()
    monkeypatch.setenv("http_proxy", proxy.url)
    monkeypatch.setenv("NO_PROXY", "example.com, localhost")
    check_whole(get(root, hub))
    assert set(proxy.targets) == {f"127.0.0.1:{hub.port}"}, "the store's name was to be spared"
    guides.remove(ID, "fp32", root)
    monkeypatch.setenv("NO_PROXY", "*")
    before = len(proxy.targets)
    get(root, hub)
    assert len(proxy.targets) == before


def test_a_proxy_that_refuses_is_a_sentence(root, hub, monkeypatch):
    monkeypatch.setenv("http_proxy", Proxy(b"407 Proxy Authentication Required").url)
    assert "the proxy does not connect to 127.0.0.1" in refusal(root, hub)
    monkeypatch.setenv("http_proxy", "http://")
    assert "is no address; correct HTTPS_PROXY" in refusal(root, hub)


@pytest.fixture
def certificate(tmp_path):
    """A certificate for this machine, signed by itself, as a file with its key."""
    path = tmp_path / "server.pem"
    command = [
        "openssl",
        "req",
        "-x509",
        "-newkey",
        "ec",
        "-pkeyopt",
        "ec_paramgen_curve:prime256v1",
        "-nodes",
    ]
    command += ["-subj", "/CN=localhost", "-addext", "subjectAltName=DNS:localhost,IP:127.0.0.1"]
    command += ["-addext", "basicConstraints=critical,CA:FALSE", "-days", "2"]
    try:
        subprocess.run(
            [*command, "-keyout", path, "-out", tmp_path / "cert.pem"], check=True, capture_output=True
        )
    except (OSError, subprocess.CalledProcessError):
        pytest.skip("openssl is not installed")
    path.write_text(path.read_text() + (tmp_path / "cert.pem").read_text())
    return path


def test_encrypted_connections_are_those_of_the_systems_certificates(root, certificate, monkeypatch):
    context = ssl.SSLContext(ssl.PROTOCOL_TLS_SERVER)
    context.load_cert_chain(certificate)
    with HubServer(context) as hub:
        assert "is not trusted" in refusal(root, hub)
        monkeypatch.setenv("SSL_CERT_FILE", str(certificate))
        check_whole(get(root, hub))


def test_misuse_is_refused(root, hub):
    with pytest.raises(ValueError, match=f'no guide "none" to download; choose .*{ID}'):
        guides.Download("none", "fp32", root)
    with pytest.raises(ValueError, match="does not come in int4; choose fp32, fp16, int8"):
        guides.presence(ID, "int4", root)
    with pytest.raises(ValueError, match="timeout must be"):
        guides.Download(ID, "fp32", root, timeout=-1.0)
    job = download(root, hub)
    with pytest.raises(RuntimeError, match="has not finished"):
        job.result()
    job.start()
    with pytest.raises(RuntimeError, match="started before"):
        job.start()
    job.join()
