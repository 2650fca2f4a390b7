# Copyright (c) 2026 The Geometric_continuity developers
#
# SPDX-License-Identifier: LGPL-3.0-or-later
"""Builds the module and the program by CMake, and packs both as a wheel: what `pip install .` calls (PEP 517). It needs nothing but
the standard library, so that nothing has to be downloaded. `--config-settings build-folder=FOLDER` keeps what was compiled there, or
takes what is; `--config-settings cmake=OPTION` passes an option to CMake. A source distribution has all files
of the repository, and packs itself again without git."""

import base64
import hashlib
import io
import os
import re
import subprocess
import sys
import sysconfig
import tarfile
import tempfile
import zipfile

TOP = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
NAME = "geometric_continuity"
SOURCES = "SOURCES.txt"
LICENCES = ("LICENSE.LGPL", "LICENSE.GPL")
CLASSIFIERS = ("Development Status :: 4 - Beta", "Intended Audience :: Developers", "Intended Audience :: Manufacturing",
               "Intended Audience :: Science/Research", "Operating System :: POSIX :: Linux", "Programming Language :: C++",
               "Programming Language :: Python :: 3", "Topic :: Multimedia :: Graphics", "Topic :: Scientific/Engineering :: Mathematics",
               "Topic :: Text Processing :: Fonts", "Typing :: Typed")


def _read(path):
    with open(os.path.join(TOP, path), encoding="utf-8") as file:
        return file.read()


def _version():
    return re.search(r"project\(Geometric_continuity VERSION ([0-9.]+)", _read("CMakeLists.txt")).group(1)


def _address():
    """Returns the address of the repository, which is empty where the project has none."""
    return re.search(r'^ *HOMEPAGE_URL "(.*?)"', _read("CMakeLists.txt"), re.MULTILINE).group(1)


def _description():
    """Returns the README as it is read outside of the repository: what it links is absolute. Without
    an address of the repository pictures are part of the text, and links are their names."""
    address, version = _address(), _version()

    def picture(match):
        text, path = match.groups()
        if address:
            return f"![{text}]({address}/raw/v{version}/{path})"
        with open(os.path.join(TOP, path), "rb") as file:
            content = base64.b64encode(file.read()).decode()
        return f"![{text}](data:image/{'svg+xml' if path.endswith('.svg') else path.rsplit('.', 1)[1]};base64,{content})"

    def link(match):
        text, path = match.groups()
        return f"[{text}]({address}/blob/v{version}/{path})" if address else text

    text = re.sub(r"!\[([^]]*)\]\((?!\w+:)([^)]*)\)", picture, _read("README.md"))
    return re.sub(r"(?<!!)\[([^]]*)\]\((?!\w+:|#)([^)]*)\)", link, text)


def _metadata():
    fields = [("Metadata-Version", "2.4"), ("Name", NAME), ("Version", _version()),
              ("Summary", "Curves and surfaces that join smoothly, and a proof that they do"),
              ("Author", "The Geometric_continuity developers"), ("License-Expression", "LGPL-3.0-or-later")]
    fields += [("License-File", name) for name in LICENCES]
    fields += [("Classifier", text) for text in CLASSIFIERS]
    if _address():
        fields += [("Project-URL", f"{name}, {_address()}{path}") for name, path in
                   (("Homepage", ""), ("Repository", ""), ("Changelog", f"/blob/v{_version()}/CHANGES.md"))]
    fields += [("Requires-Python", ">=3.8"), ("Requires-Dist", "numpy"), ("Description-Content-Type", "text/markdown")]
    return "".join(f"{name}: {value}\n" for name, value in fields) + "\n" + _description()


def _tag():
    python = f"cp{sys.version_info[0]}{sys.version_info[1]}"
    return f"{python}-{python}-{re.sub('[-.]', '_', sysconfig.get_platform())}"


def _build(folder, options):
    def run(*command):
        subprocess.run(command, check=True, stdout=sys.stderr)

    run("cmake", "-S", TOP, "-B", folder, f"-DPython_EXECUTABLE={sys.executable}", "-DBUILD_TESTING=OFF",
        "-DGEOMETRIC_CONTINUITY_REQUIRE_PYTHON=ON", *options)
    jobs = str(len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count() or 1)
    run("cmake", "--build", folder, "-j", jobs, "--target", NAME, "geometric_continuity_python")


def _files(folder):
    """Name in the wheel, path, and whether it is a program."""
    package = os.path.join(folder, "python", NAME)
    for base, folders, names in os.walk(package):
        folders[:] = [f for f in folders if f != "__pycache__"]
        for name in sorted(names):
            path = os.path.join(base, name)
            yield os.path.join(NAME, os.path.relpath(path, package)), path, False
    yield f"{NAME}/bin/{NAME}", os.path.join(folder, "tools", NAME), True
    reader = os.path.join(folder, "tools", "geometric_continuity_cad")
    if os.path.exists(reader):
        yield f"{NAME}/bin/geometric_continuity_cad", reader, True


def get_requires_for_build_wheel(config_settings=None):
    return []


def get_requires_for_build_sdist(config_settings=None):
    return []


def _texts(info):
    """The files of the wheel that describe it, but the list of all files."""
    yield f"{info}/METADATA", _metadata()
    yield f"{info}/WHEEL", f"Wheel-Version: 1.0\nGenerator: {NAME}\nRoot-Is-Purelib: false\nTag: {_tag()}\n"
    yield f"{info}/entry_points.txt", f"[console_scripts]\n{NAME} = {NAME}.program:main\n"


def prepare_metadata_for_build_wheel(metadata_directory, config_settings=None):
    info = f"{NAME}-{_version()}.dist-info"
    os.makedirs(os.path.join(metadata_directory, info), exist_ok=True)
    for name, text in _texts(info):
        with open(os.path.join(metadata_directory, name), "w", encoding="utf-8") as file:
            file.write(text)
    return info


def build_wheel(wheel_directory, config_settings=None, metadata_directory=None):
    settings = config_settings or {}
    options = settings.get("cmake", [])
    options = [options] if isinstance(options, str) else list(options)
    with tempfile.TemporaryDirectory() as temporary:
        folder = os.path.abspath(settings.get("build-folder", temporary))
        _build(folder, options)
        info = f"{NAME}-{_version()}.dist-info"
        wheel = f"{NAME}-{_version()}-{_tag()}.whl"
        record = []
        with zipfile.ZipFile(os.path.join(wheel_directory, wheel), "w", zipfile.ZIP_DEFLATED) as archive:

            def add(name, content, is_program=False):
                entry = zipfile.ZipInfo(name)
                entry.compress_type = zipfile.ZIP_DEFLATED
                entry.external_attr = (0o100755 if is_program else 0o100644) << 16
                archive.writestr(entry, content)
                digest = base64.urlsafe_b64encode(hashlib.sha256(content).digest()).rstrip(b"=").decode()
                record.append(f"{name},sha256={digest},{len(content)}\n")

            for name, path, is_program in _files(folder):
                with open(path, "rb") as file:
                    add(name, file.read(), is_program)
            for licence in LICENCES:
                with open(os.path.join(TOP, licence), "rb") as file:
                    add(f"{info}/licenses/{licence}", file.read())
            for name, text in _texts(info):
                add(name, text.encode())
            record.append(f"{info}/RECORD,,\n")
            archive.writestr(f"{info}/RECORD", "".join(record))
    return wheel


def _sources():
    """Returns the names of the files of the repository, of which a source distribution has a list."""
    if os.path.exists(os.path.join(TOP, SOURCES)):
        return _read(SOURCES).splitlines()
    listed = subprocess.run(["git", "-C", TOP, "ls-files", "-z"], check=True, stdout=subprocess.PIPE).stdout.decode()
    return [name for name in listed.split("\0") if name]


def build_sdist(sdist_directory, config_settings=None):
    """Packs the files of the repository."""
    name = f"{NAME}-{_version()}"
    with tarfile.open(os.path.join(sdist_directory, name + ".tar.gz"), "w:gz", format=tarfile.PAX_FORMAT) as archive:

        def owned_by_root(entry):
            entry.uid = entry.gid = 0
            entry.uname = entry.gname = "root"
            return entry

        names = _sources()
        for path in names:
            archive.add(os.path.join(TOP, path), f"{name}/{path}", recursive=False, filter=owned_by_root)
        for path, text in (("PKG-INFO", _metadata()), (SOURCES, "".join(f"{n}\n" for n in names))):
            entry = owned_by_root(tarfile.TarInfo(f"{name}/{path}"))
            entry.size = len(text.encode())
            archive.addfile(entry, io.BytesIO(text.encode()))
    return name + ".tar.gz"


if __name__ == "__main__":  # build_wheel.py sdist|wheel FOLDER, which pip and build do by themselves
    kind, target = sys.argv[1:]
    os.makedirs(target, exist_ok=True)
    print(os.path.join(target, {"sdist": build_sdist, "wheel": build_wheel}[kind](target)))
