#!/usr/bin/env python3
# Copyright (c) 2026 The Geometric_continuity developers
#
# SPDX-License-Identifier: LGPL-3.0-or-later
"""Reads all pages of the manual and prints what is wrong: links to files and anchors that do not
exist, and descriptions that begin with the mark of a comment. Usage: test_links.py HTML_FOLDER"""

import os
import re
import sys
from html.parser import HTMLParser
from urllib.parse import unquote


class Page(HTMLParser):
    def __init__(self, path):
        super().__init__()
        self.anchors, self.links, self.marks = {""}, set(), []
        self.description = False
        with open(path, encoding="utf-8") as file:
            self.feed(file.read())

    def handle_starttag(self, tag, attrs):
        attributes = dict(attrs)
        self.anchors |= {attributes[key] for key in ("id", "name") if attributes.get(key)}
        self.links |= {unquote(attributes[key]) for key in ("href", "src", "data") if attributes.get(key)}
        self.description = attributes.get("class") == "mdescRight" or tag == "p" or self.description and tag == "a"

    def handle_data(self, data):
        if self.description and re.match(r"\s*[<*/!]+ ", data):
            self.marks.append(data.strip()[:60])
        self.description = False


def main():
    os.chdir(sys.argv[1])
    pages = {name: Page(name) for name in sorted(os.listdir()) if name.endswith(".html") and name != "geometric_continuity.html"}
    links = problems = 0
    for name, page in pages.items():
        wrong = [f'a description begins with a mark: "{text}"' for text in page.marks]
        for link in sorted(page.links):
            if re.match(r"[a-z]+:", link):
                continue
            links += 1
            file, _, anchor = link.partition("#")
            file = file or name
            if file in pages and anchor not in pages[file].anchors:
                wrong.append(f"{link}: there is no such anchor")
            elif not os.path.exists(file):
                wrong.append(f"{link}: there is no such file")
        problems += len(wrong)
        for text in wrong[:3]:
            print(f"{name}: {text}")
    print(f"{links} links of {len(pages)} pages, {problems} problems")
    return problems > 0 or links < 10000


sys.exit(main())
