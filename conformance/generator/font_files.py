# SPDX-License-Identifier: CC0-1.0
"""The bytes of small fonts with a glyph for the letter A: TrueType outlines, with variations or
without, and CFF."""

import struct


def pack(format, *values):
    return struct.pack(">" + format, *values)


def checksum(data):
    data += b"\0" * (-len(data) % 4)
    return sum(struct.unpack(f">{len(data) // 4}I", data)) & 0xFFFFFFFF


def container(version, tables):
    names = sorted(tables)
    n = len(names)
    power = 2 ** (n.bit_length() - 1)
    header = version + pack("HHHH", n, power * 16, power.bit_length() - 1, n * 16 - power * 16)
    offset, directory, body = 12 + 16 * n, b"", b""
    for name in names:
        data = tables[name]
        directory += name.encode() + pack("III", checksum(data), offset + len(body), len(data))
        body += data + b"\0" * (-len(data) % 4)
    font = header + directory + body
    at = font.index(b"head") + 8
    head = struct.unpack(">I", font[at : at + 4])[0]
    return font[: head + 8] + pack("I", (0xB1B0AFBA - checksum(font)) & 0xFFFFFFFF) + font[head + 12 :]


def name_table(axes):
    texts = [(1, "Conformance"), (2, "Regular"), (3, "Conformance"), (4, "Conformance"), (6, "Conformance")]
    texts += [(256 + i, tag) for i, tag in enumerate(axes)]
    records, store = b"", b""
    for number, text in texts:
        data = text.encode("utf-16-be")
        records += pack("HHHHHH", 3, 1, 0x409, number, len(data), len(store))
        store += data
    return pack("HHH", 0, len(texts), 6 + len(records)) + records + store


def common(box, count, em, axes=()):
    """The tables that any font has."""
    lowest, highest = min(box[1], 0), max(box[3], 1)
    segments = pack("HHHHHHH", 4, 32, 0, 4, 4, 1, 0) + pack("HH", 65, 0xFFFF) + pack("H", 0) + pack("HH", 65, 0xFFFF) + pack("hh", 1 - 65, 1) + pack("HH", 0, 0)
    return {
        "OS/2": pack("HhHHH", 4, em // 2, 400, 5, 0) + pack("10h", *([em // 10] * 10)) + pack("h", 0) + bytes(10) + pack("IIII", 1, 0, 0, 0) + b"NONE"
                + pack("HHH", 0x40, 65, 65) + pack("hhhHH", highest, lowest, 0, highest, abs(lowest)) + pack("II", 1, 0) + pack("hhHHH", em // 2, em // 2, 0, 32, 1),
        "cmap": pack("HHHHI", 0, 1, 3, 1, 12) + segments,
        "head": pack("IIIIHHQQhhhhHHhhh", 0x10000, 0x10000, 0, 0x5F0F3CF5, 3, em, 0, 0, *box, 0, 8, 2, 1, 0),
        "hhea": pack("IhhhHhhhhhhhhhhhH", 0x10000, highest, lowest, 0, em, box[0], 0, box[2], 1, 0, 0, 0, 0, 0, 0, 0, count),
        "hmtx": pack("Hh", em, box[0]) * count,
        "name": name_table(axes),
        "post": pack("IIhhIIIII", 0x30000, 0, 0, 0, 0, 0, 0, 0, 0),
    }


def bounds(contours):
    xs, ys = [p[0] for c in contours for p in c], [p[1] for c in contours for p in c]
    return min(xs), min(ys), max(xs), max(ys)


def simple_glyph(contours):
    """Points are (x, y, is on the curve)."""
    ends, flags, x_data, y_data, last, count = b"", b"", b"", b"", (0, 0), 0
    for c in contours:
        count += len(c)
        ends += pack("H", count - 1)
        for x, y, on in c:
            flags += pack("B", 1 if on else 0)
            x_data += pack("h", x - last[0])
            y_data += pack("h", y - last[1])
            last = x, y
    return pack("hhhhh", len(contours), *bounds(contours)) + ends + pack("H", 0) + flags + x_data + y_data


def component_glyph(glyph, box, matrix):
    """Another glyph, by a matrix of numbers with 14 binary digits."""
    return pack("hhhhh", -1, *box) + pack("HHhh", 0x0001 | 0x0002 | 0x0080, glyph, 0, 0) + pack("hhhh", *(int(m * 16384) for m in matrix))


def deltas(values):
    data = b""
    for i in range(0, len(values), 64):
        run = values[i : i + 64]
        data += pack("B", 0x40 | (len(run) - 1)) + pack(f"{len(run)}h", *run)
    return data


def variations(axes, glyphs):
    """Tables of the variations: per glyph a list of (peak, begin, end, moves), with a move for each point, or {point: move}."""
    n = len(axes)
    fvar = pack("HHHHHHHH", 1, 0, 16, 2, n, 20, 0, 4 + 4 * n)
    for i, tag in enumerate(axes):
        fvar += tag.encode() + pack("iiiHH", 0, 0, 1 << 16, 0, 256 + i)
    offsets, body = [0], b""
    for tuples in glyphs:
        headers = payload = b""
        for peak, begin, end, moves in tuples:
            if isinstance(moves, dict):
                numbers = sorted(moves)
                points = pack("BB", len(numbers), len(numbers) - 1) + bytes(b - a for a, b in zip([0] + numbers, numbers))
                moved = [moves[k] for k in numbers]
            else:
                points, moved = b"\0", list(moves) + [(0, 0)] * 4
            data = points + deltas([m[0] for m in moved]) + deltas([m[1] for m in moved])
            headers += pack("HH", len(data), 0x8000 | 0x2000 | (0x4000 if begin else 0)) + pack(f"{n}h", *(int(p * 16384) for p in peak))
            if begin:
                headers += pack(f"{2 * n}h", *(int(p * 16384) for p in begin + end))
            payload += data
        if tuples:
            glyph = pack("HH", len(tuples), 4 + len(headers)) + headers + payload
            body += glyph + b"\0" * (-len(glyph) % 4)
        offsets.append(len(body))
    head = pack("HHHHIHHI", 1, 0, n, 0, 20 + 4 * len(offsets), len(glyphs), 1, 20 + 4 * len(offsets))
    return {"fvar": fvar, "gvar": head + pack(f"{len(offsets)}I", *offsets) + body}


def true_type(contours, em=1000, component=None, axes=(), tuples=()):
    """With `component`, a matrix, the letter is the glyph of these contours by that matrix."""
    glyphs = [b"", simple_glyph(contours)]
    box = bounds(contours)
    if component:
        glyphs = [b"", component_glyph(2, box, component), simple_glyph(contours)]
    glyphs = [g + b"\0" * (-len(g) % 4) for g in glyphs]
    tables = common(box, len(glyphs), em, axes)
    offsets = [sum(map(len, glyphs[:i])) for i in range(len(glyphs) + 1)]
    points = sum(map(len, contours))
    tables["glyf"] = b"".join(glyphs)
    tables["loca"] = pack(f"{len(offsets)}I", *offsets)
    tables["maxp"] = pack("IHHHHHHHHHHHHHH", 0x10000, len(glyphs), points, len(contours), points, len(contours), 1, 0, 0, 0, 0, 0, 0, 1 if component else 0, 1 if component else 0)
    if axes:
        tables.update(variations(axes, [[], list(tuples)]))
    return container(b"\0\1\0\0", tables)


def index(items):
    if not items:
        return pack("H", 0)
    offsets, at = b"", 1
    for item in [b""] + items:
        at += len(item)
        offsets += pack("H", at)
    return pack("HB", len(items), 2) + offsets + b"".join(items)


def cff_number(v):
    """In dictionaries, as five bytes."""
    return b"\x1d" + pack("i", v)


def charstring(words):
    """Numbers and the names of operators. A fraction is written with 16 binary digits."""
    operators = {"hstem": 1, "rmoveto": 21, "hmoveto": 22, "vmoveto": 4, "rlineto": 5, "hlineto": 6, "vlineto": 7, "rrcurveto": 8, "callsubr": 10, "return": 11,
                 "endchar": 14, "rcurveline": 24, "rlinecurve": 25, "vvcurveto": 26, "hhcurveto": 27, "vhcurveto": 30, "hvcurveto": 31}
    data = b""
    for w in words:
        if isinstance(w, str):
            data += b"\x0c\x23" if w == "flex" else pack("B", operators[w])
        elif w == int(w):
            data += b"\x1c" + pack("h", int(w))
        else:
            data += b"\xff" + pack("i", int(w * 65536))
    return data


def compact(words, box, em=1000, subroutine=None):
    """A font with CFF outlines, whose letter is a charstring; `subroutine` is its only local one."""
    strings = index([charstring(["endchar"]), charstring(words)])
    # defaultWidthX, and the subroutines stand behind the dictionary
    private = cff_number(em) + b"\x14" + (cff_number(12) + b"\x13" if subroutine else b"")
    subroutines = index([charstring(subroutine)]) if subroutine else b""
    names, empty = index([b"Conformance"]), index([])
    charset = b"\0" + pack("H", 34)
    begin = 4 + len(names) + len(index([bytes(23)])) + 2 * len(empty)
    at_strings = begin + len(charset)
    at_private = at_strings + len(strings)
    top = cff_number(begin) + b"\x0f" + cff_number(at_strings) + b"\x11" + cff_number(len(private)) + cff_number(at_private) + b"\x12"
    data = b"\1\0\4\2" + names + index([top]) + empty + empty + charset + strings + private + subroutines
    tables = common(box, 2, em)
    tables["CFF "] = data
    tables["maxp"] = pack("IH", 0x5000, 2)
    return container(b"OTTO", tables)
