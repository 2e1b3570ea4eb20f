# SPDX-License-Identifier: MIT OR Apache-2.0
"""Drops a file on the window below a point of the screen, as a file manager does (the XDND protocol).

    python3 screen_drop.py FILE X Y

Ends with status 0 when the window has taken the file.
"""

import ctypes
import pathlib
import sys
import time

X = ctypes.CDLL("libX11.so.6")
CLIENT_MESSAGE, SELECTION_REQUEST, SELECTION_NOTIFY = 33, 30, 31
XDND_VERSION = 5

_long, _ulong, _int, _pointer = ctypes.c_long, ctypes.c_ulong, ctypes.c_int, ctypes.c_void_p
_start = [("type", _int), ("serial", _ulong), ("send_event", _int), ("display", _pointer)]


class ClientMessage(ctypes.Structure):
    _fields_ = [*_start, ("window", _ulong), ("kind", _ulong), ("format", _int), ("data", _long * 5)]


class SelectionRequest(ctypes.Structure):
    _fields_ = [*_start] + [
        (name, _ulong) for name in ("owner", "requestor", "selection", "target", "property", "time")
    ]


class SelectionNotify(ctypes.Structure):
    _fields_ = [*_start] + [
        (name, _ulong) for name in ("requestor", "selection", "target", "property", "time")
    ]


class Event(ctypes.Union):
    _fields_ = [
        *(("type", _int), ("message", ClientMessage), ("request", SelectionRequest)),
        *(("notify", SelectionNotify), ("pad", _long * 24)),
    ]


X.XOpenDisplay.restype = _pointer
X.XDefaultRootWindow.argtypes, X.XDefaultRootWindow.restype = [_pointer], _ulong
X.XInternAtom.argtypes, X.XInternAtom.restype = [_pointer, ctypes.c_char_p, _int], _ulong
X.XCreateSimpleWindow.argtypes = [_pointer, _ulong, _int, _int, *[ctypes.c_uint] * 3, _ulong, _ulong]
X.XCreateSimpleWindow.restype = _ulong
X.XSetSelectionOwner.argtypes = [_pointer, _ulong, _ulong, _ulong]
X.XTranslateCoordinates.argtypes = [_pointer, _ulong, _ulong, _int, _int, *[_pointer] * 3]
X.XSendEvent.argtypes = [_pointer, _ulong, _int, _long, _pointer]
X.XChangeProperty.argtypes = [_pointer, *[_ulong] * 3, _int, _int, ctypes.c_char_p, _int]
X.XPending.argtypes = X.XFlush.argtypes = [_pointer]
X.XNextEvent.argtypes = [_pointer, _pointer]


class Source:
    """A window without a picture, from which a file is dragged."""

    def __init__(self, uris):
        self.uris = uris
        self.display = X.XOpenDisplay(None)
        self.root = X.XDefaultRootWindow(self.display)
        self.window = X.XCreateSimpleWindow(self.display, self.root, 0, 0, 1, 1, 0, 0, 0)
        X.XSetSelectionOwner(self.display, self.atom("XdndSelection"), self.window, 0)

    def atom(self, name):
        return X.XInternAtom(self.display, name.encode(), 0)

    def below(self, x, y):
        """Return the top-level window at a point of the screen."""
        left, top, child = _int(), _int(), _ulong()
        where = (ctypes.byref(left), ctypes.byref(top), ctypes.byref(child))
        X.XTranslateCoordinates(self.display, self.root, self.root, x, y, *where)
        return child.value

    def send(self, target, kind, *data):
        """Send a message of the protocol; its first datum is always our window."""
        event = Event()
        message = event.message
        message.type, message.window, message.kind, message.format = (
            *(CLIENT_MESSAGE, target, self.atom(kind)),
            32,
        )
        message.data = (_long * 5)(self.window, *data)
        X.XSendEvent(self.display, target, 0, 0, ctypes.byref(event))
        X.XFlush(self.display)

    def wait(self, kind, seconds=20):
        """Answer requests for the file until a message of `kind` comes; return its data."""
        until = time.monotonic() + seconds
        event = Event()
        while time.monotonic() < until:
            if not X.XPending(self.display):
                time.sleep(0.02)
                continue
            X.XNextEvent(self.display, ctypes.byref(event))
            if event.type == SELECTION_REQUEST:
                self.hand_over(event.request)
            elif event.type == CLIENT_MESSAGE and event.message.kind == self.atom(kind):
                return list(event.message.data)
        raise SystemExit(f"no {kind} came within {seconds} s")

    def hand_over(self, request):
        """Give the list of files to the window that asks for it."""
        where = (self.display, request.requestor, request.property, request.target)
        X.XChangeProperty(*where, 8, 0, self.uris, len(self.uris))
        answer = Event()
        notify = answer.notify
        notify.type, notify.requestor, notify.selection = (
            *(SELECTION_NOTIFY, request.requestor),
            request.selection,
        )
        notify.target, notify.property, notify.time = request.target, request.property, request.time
        X.XSendEvent(self.display, request.requestor, 0, 0, ctypes.byref(answer))
        X.XFlush(self.display)


def drop(path, x, y):
    """Drag `path` to a point of the screen and let it go."""
    source = Source(f"{pathlib.Path(path).as_uri()}\r\n".encode())
    target = source.below(x, y)
    source.send(target, "XdndEnter", XDND_VERSION << 24, source.atom("text/uri-list"), 0, 0)
    # A hand moves before it lets go.
    for step in (8, 4, 0):
        source.send(target, "XdndPosition", 0, (x - step) << 16 | y, 0, source.atom("XdndActionCopy"))
        accepted = source.wait("XdndStatus")[1] & 1
        time.sleep(0.2)
    if not accepted:
        raise SystemExit("the window does not take files")
    source.send(target, "XdndDrop", 0, 0, 0, 0)
    source.wait("XdndFinished")


if __name__ == "__main__":
    drop(sys.argv[1], int(sys.argv[2]), int(sys.argv[3]))
