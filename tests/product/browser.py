"""Runs a headless Chromium that opens pages from files, with the network off, and reports what it
saw.

It is controlled through its debugging pipe: JSON messages that end with a zero byte.
"""

import base64
import contextlib
import fcntl
import json
import os
import select
import subprocess
import tempfile
import time
from collections.abc import Iterator
from dataclasses import dataclass, field
from pathlib import Path

from tmap.base.silence import Silence

PROGRAM = "chromium-headless-shell"
SECONDS = 30.0  # of processor time for a page
LOOKS = 0.2  # seconds between two checks of that time
#: The browser's own services must not use the network either.
OPTIONS = ("--no-sandbox", "--disable-gpu", "--no-first-run", "--disable-background-networking",
           "--host-resolver-rules=MAP * ~NOTFOUND", "--remote-debugging-pipe")
#: Loads all pictures, including those further down, waits for them, and returns the page's state.
LOOK = """(async () => {
  for (const each of document.querySelectorAll('details')) each.open = OPENED;
  const pictures = [...document.images];
  for (const each of pictures) each.loading = 'eager';
  await Promise.all(pictures.filter(each => each.checkVisibility()).map(
    each => each.decode().catch(() => {})));
  const root = document.documentElement, most = WIDTH;
  const outside = each => {
    if (each.getBoundingClientRect().right <= most + 0.5) return false;
    for (let up = each.parentElement; up; up = up.parentElement)
      if (getComputedStyle(up).overflowX != 'visible' && up != root && up != document.body)
        return false;
    return true;
  };
  return {width: root.scrollWidth, height: root.scrollHeight,
    broken: pictures.filter(each => each.checkVisibility() && !each.naturalWidth).map(
      each => each.src),
    pictures: pictures.length,
    wide: [...document.body.querySelectorAll('*')].filter(outside).map(
      each => each.outerHTML.slice(0, 80)),
    missing: [...document.querySelectorAll('a[href^="#"]')].map(each => each.hash.slice(1)).filter(
      each => !document.getElementById(each))};
})()"""


@dataclass
class View:
    """A page as displayed: LOOK's result, the requests, and a picture."""

    page: dict
    requests: list[str] = field(default_factory=list)
    failures: list[str] = field(default_factory=list)
    png: bytes = b""


class Browser:
    """One process; ``call`` sends messages, events are kept."""

    def __init__(self, pid: int, orders: int, answers: int):
        self.pid, self.orders, self.answers = pid, orders, answers
        self.number, self.rest, self.events = 0, b"", []
        self.session: str | None = None

    def message(self, silence: Silence) -> dict:
        """Reads the next message."""
        while b"\0" not in self.rest:
            if not select.select([self.answers], [], [], LOOKS)[0]:
                if said := silence.end():
                    raise TimeoutError(f"{PROGRAM} did not answer, {said}")
                continue
            more = os.read(self.answers, 1 << 20)
            if not more:
                raise EOFError(f"{PROGRAM} ended")
            self.rest += more
        text, self.rest = self.rest.split(b"\0", 1)
        return json.loads(text)

    def call(self, method: str, **parameters) -> dict:
        """Sends a request; returns its answer."""
        self.number += 1
        order = {"id": self.number, "method": method, "params": parameters}
        if self.session:
            order["sessionId"] = self.session
        os.write(self.orders, json.dumps(order).encode() + b"\0")
        silence = Silence(self.pid, SECONDS)
        while True:
            message = self.message(silence)
            if message.get("id") == self.number:
                if "error" in message:
                    raise RuntimeError(f"{method}: {message['error']['message']}")
                return message["result"]
            self.events.append(message)

    def wait(self, method: str) -> None:
        """Waits for an event."""
        silence = Silence(self.pid, SECONDS)
        while not any(event.get("method") == method for event in self.events):
            self.events.append(self.message(silence))

    def look(self, path: Path, width: int, height: int, opened: bool = False) -> View:
        """Opens a file at a size in pixels and examines the whole page; ``opened``: details
        unfolded."""
        target = self.call("Target.createTarget", url="about:blank")["targetId"]
        attached = self.call("Target.attachToTarget", targetId=target, flatten=True)
        self.session = attached["sessionId"]
        try:
            for domain in ("Page", "Network", "Runtime"):
                self.call(f"{domain}.enable")
            self.call("Network.emulateNetworkConditions", offline=True, latency=0,
                      downloadThroughput=-1, uploadThroughput=-1)
            self.call("Emulation.setDeviceMetricsOverride", width=width, height=height,
                      deviceScaleFactor=1, mobile=width < 600)
            self.events = []
            self.call("Page.navigate", url=path.resolve().as_uri())
            self.wait("Page.loadEventFired")
            found = self.call("Runtime.evaluate", awaitPromise=True, returnByValue=True,
                              expression=LOOK.replace("OPENED", str(opened).lower())
                              .replace("WIDTH", str(width)))
            if "exceptionDetails" in found:
                raise RuntimeError(found["exceptionDetails"]["exception"]["description"])
            view = View(found["result"]["value"])
            whole = {"x": 0, "y": 0, "width": width, "height": view.page["height"], "scale": 1}
            view.png = base64.b64decode(self.call(
                "Page.captureScreenshot", captureBeyondViewport=True, clip=whole)["data"])
            for event in self.events:
                if event.get("method") == "Network.requestWillBeSent":
                    view.requests.append(event["params"]["request"]["url"])
                if event.get("method") == "Network.loadingFailed":
                    view.failures.append(event["params"]["errorText"])
            return view
        finally:
            self.session = None
            self.call("Target.closeTarget", targetId=target)


@contextlib.contextmanager
def browser() -> Iterator[Browser]:
    """A browser with an empty profile, ended afterwards."""
    in_read, in_write = os.pipe()
    out_read, out_write = os.pipe()
    # Avoids 3 and 4, which the browser expects to be its pipe.
    ends = [fcntl.fcntl(end, fcntl.F_DUPFD_CLOEXEC, 10) for end in (in_read, out_write)]
    os.close(in_read)
    os.close(out_write)
    # The browser's last processes may still write into its profile while that is removed.
    with tempfile.TemporaryDirectory(prefix="tmap-", ignore_cleanup_errors=True) as profile:
        shell = f'exec "$@" 3<&{ends[0]} 4>&{ends[1]}'
        process = subprocess.Popen(
            ["bash", "-c", shell, "bash", PROGRAM, *OPTIONS, f"--user-data-dir={profile}"],
            stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL,
            pass_fds=ends)
        for end in ends:
            os.close(end)
        made = Browser(process.pid, in_write, out_read)
        try:
            yield made
            made.call("Browser.close")
            silence = Silence(process.pid, SECONDS)
            while process.poll() is None and not silence.end():
                time.sleep(LOOKS)
        finally:
            process.kill()
            process.wait()
            os.close(in_write)
            os.close(out_read)
