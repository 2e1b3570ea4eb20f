# SPDX-License-Identifier: MIT OR Apache-2.0
"""A server on this machine that speaks the hub's protocol and has the embedded guide under every repository's
name, whole or with faults.

    python3 hub_server.py PORT_FILE [BYTES_PER_SECOND [CUT_AFTER_BYTES]]

serves until it is killed, and writes its port into PORT_FILE. With CUT_AFTER_BYTES the first transfer of a
large file breaks off there.
"""

import hashlib
import re
import sys
import threading
import time
from http.server import BaseHTTPRequestHandler, ThreadingHTTPServer
from pathlib import Path

MINI = Path(__file__).resolve().parents[2] / "guides" / "mini"
COMMIT = "0123456789abcdef0123456789abcdef01234567"
PIECE = 1 << 14


def git_blob(data):
    """Return git's hash of a file."""
    return hashlib.sha1(b"blob %d\0" % len(data) + data).hexdigest()


class HubServer(ThreadingHTTPServer):
    """The server, running from the start; close it, or use it as a context manager.

    Its faults are attributes, to be changed while it runs.
    """

    daemon_threads = True

    def __init__(self, tls=None):
        super().__init__(("127.0.0.1", 0), _Handler)
        if tls is not None:
            self.socket = tls.wrap_socket(self.socket, server_side=True)
        self.scheme = "http" if tls is None else "https"
        self.log = []  #: (method, path, Range header or None)
        self.statuses = {}  #: by a part of a path: the statuses of its next answers
        self.retry_after = None  #: seconds, with each of those
        self.headers = {}  #: by a part of a path: headers that replace those of its answers
        self.redirects = {}  #: by a part of a path: where it leads to
        self.cuts = []  #: bytes after which the next transfers of large files break off
        self.swapped = {}  #: by a part of a path: bytes sent in place of the file's
        self.rate = None  #: bytes a second of large files
        self.silent = ""  #: a part of a path that is never answered
        self.knows_ranges = True
        threading.Thread(target=self.serve_forever, daemon=True).start()

    @property
    def port(self):
        return self.server_address[1]

    @property
    def url(self):
        return f"{self.scheme}://127.0.0.1:{self.port}"

    def paths(self, method="GET", part=""):
        """Return the paths of the requests so far."""
        return [path for verb, path, _range in self.log if verb == method and part in path]

    def __exit__(self, *arguments):
        self.shutdown()
        super().__exit__(*arguments)

    def handle_error(self, *_):
        """Connections that clients break off are no news."""


def content(name):
    """Return the bytes of a file in any repository, or None."""
    name = re.sub(r"^onnx/(vision|text)_model(_\w+)?\.onnx$", r"\1_model.onnx", name)
    path = MINI / name
    return path.read_bytes() if path.is_file() and name != "README.md" else None


class _Handler(BaseHTTPRequestHandler):
    protocol_version = "HTTP/1.1"

    def do_HEAD(self):
        self.do_GET()

    def do_GET(self):
        hub = self.server
        hub.log.append((self.command, self.path, self.headers.get("Range")))
        if hub.silent and hub.silent in self.path:
            time.sleep(60)
            return
        for part, statuses in hub.statuses.items():
            if part in self.path and statuses:
                headers = {} if hub.retry_after is None else {"Retry-After": str(hub.retry_after)}
                return self._answer(statuses.pop(0), headers)
        for part, target in hub.redirects.items():
            if part in self.path:
                return self._answer(302, {"Location": target})
        place = re.fullmatch(r"/([^/]+/[^/]+)/resolve/([^/]+)/(.+)", self.path)
        if place is not None:
            return self._resolve(*place.groups())
        cached = re.fullmatch(r"/api/resolve-cache/(.+)", self.path)
        if cached is not None:
            data = content(cached[1])
            return self._send(data, {"ETag": f'"{git_blob(data)}"', "X-Repo-Commit": COMMIT})
        stored = re.fullmatch(r"/cdn/(.+)\?.*", self.path)
        if stored is not None:
            return self._send(content(stored[1]), {"ETag": '"of the store"'}, large=True)
        return self._answer(404, {})

    def _resolve(self, _repository, revision, name):
        """Answer as the hub does: small files lie with it, large ones elsewhere."""
        data = content(name)
        if data is None:
            return self._answer(404, {"X-Error-Code": "EntryNotFound"})
        headers = {"X-Repo-Commit": revision if re.fullmatch("[0-9a-f]{40}", revision) else COMMIT}
        if name.endswith(".onnx"):
            headers["X-Linked-Etag"] = f'"{hashlib.sha256(data).hexdigest()}"'
            headers["X-Linked-Size"] = str(len(data))
            # Another name of this machine: to the client, another server.
            place = f"{self.server.scheme}://localhost:{self.server.port}"
            return self._answer(302, {**headers, "Location": f"{place}/cdn/{name}?signature=x"})
        return self._answer(307, {**headers, "Location": f"/api/resolve-cache/{name}"})

    def _send(self, data, headers, large=False):
        hub = self.server
        for part, other in hub.swapped.items():
            if part in self.path:
                data = other
        begin, status = 0, 200
        asked = re.fullmatch(r"bytes=(\d+)-", self.headers.get("Range") or "")
        if asked and hub.knows_ranges:
            begin, status = int(asked[1]), 206
            if begin >= len(data):
                return self._answer(416, {})
            headers = {**headers, "Content-Range": f"bytes {begin}-{len(data) - 1}/{len(data)}"}
        body = memoryview(data)[begin:]
        self._head(status, {**headers, "Content-Length": str(len(body))})
        if self.command == "HEAD":
            return None
        until = len(body)
        if large and hub.cuts:
            until = min(until, hub.cuts.pop(0))
        for start in range(0, until, PIECE):
            self.wfile.write(body[start : min(start + PIECE, until)])
            if large and hub.rate:
                time.sleep(PIECE / hub.rate)
        if until < len(body):
            self.close_connection = True
        return None

    def _answer(self, status, headers):
        self._head(status, {**headers, "Content-Length": "0"})

    def _head(self, status, headers):
        for part, replaced in self.server.headers.items():
            if part in self.path:
                headers = {**headers, **replaced}
        self.send_response(status)
        for name, value in headers.items():
            if value is not None:
                self.send_header(name, value)
        self.end_headers()

    def log_message(self, *_):
        pass


def main(port_file, rate=None, cut=None):
    server = HubServer()
    server.rate = rate and int(rate)
    server.cuts = [int(cut)] if cut else []
    Path(port_file).write_text(str(server.port))
    while True:
        time.sleep(60)


if __name__ == "__main__":
    main(*sys.argv[1:])
