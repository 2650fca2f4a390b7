# Copyright (c) 2026 The Geometric_continuity developers
#
# SPDX-License-Identifier: LGPL-3.0-or-later
"""A call that is interrupted as by Ctrl-C."""

import os
import signal
import threading
import time


def seconds_until(call, after=0.3):
    """How long `call` goes on after SIGINT, which is sent after some time. It must end by KeyboardInterrupt."""
    sent = []

    def interrupt():
        sent.append(time.monotonic())
        os.kill(os.getpid(), signal.SIGINT)

    before = signal.signal(signal.SIGINT, signal.default_int_handler)
    timer = threading.Timer(after, interrupt)
    try:
        timer.start()
        try:
            call()
        except KeyboardInterrupt:
            return time.monotonic() - sent[0]
        raise AssertionError("the call ended before it was interrupted")
    finally:
        timer.cancel()
        timer.join()
        signal.signal(signal.SIGINT, before)
