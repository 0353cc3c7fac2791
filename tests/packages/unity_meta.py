"""unity_meta.py FOLDER: the .meta files of a Unity package are read as Unity reads them, which says nothing where they are wrong.

A library without a full PluginImporter is not loaded; one for any platform goes into builds for other processors.
"""
import os
import re
import sys

# What the name of a library says: platform of a build, system of the editor.
_PLATFORMS = {".dll": ("Win64", "Windows"), ".so": ("Linux64", "Linux"), ".dylib": ("OSXUniversal", "OSX")}
_PROCESSORS = {"Win64": {"x86_64"}, "Linux64": {"x86_64"}, "OSXUniversal": {"x86_64", "ARM64", "AnyCPU"}}


def read(text):
    """The YAML of a .meta file: maps by indentation, and lists of maps, as nested dict and list."""
    root = {}
    stack = [(-1, root)]
    lines = [line for line in text.splitlines() if line.strip()]
    for number, line in enumerate(lines):
        indent = len(line) - len(line.lstrip(" "))
        content = line.strip()
        if content.startswith("- "):
            while stack[-1][0] > indent or (stack[-1][0] == indent and not isinstance(stack[-1][1], list)):
                stack.pop()
            items = stack[-1][1]
            assert isinstance(items, list), f"a list where none begins: {line}"
            items.append({})
            stack.append((indent + 2, items[-1]))
            indent, content = indent + 2, content[2:]
        else:
            while len(stack) > 1 and (stack[-1][0] > indent or isinstance(stack[-1][1], list)):
                stack.pop()
        key, colon, value = content.partition(":")
        assert colon, f"no key: {line}"
        value = value.strip()
        below = lines[number + 1] if number + 1 < len(lines) else ""
        deeper = len(below) - len(below.lstrip(" "))
        holder = stack[-1][1]
        assert isinstance(holder, dict) and key not in holder, f"twice or out of place: {line}"
        if value:
            holder[key] = value
        elif below.strip().startswith("- ") and deeper >= indent:
            holder[key] = []
            stack.append((deeper, holder[key]))
        elif deeper > indent:
            holder[key] = {}
            stack.append((deeper, holder[key]))
        else:
            holder[key] = None
    return root


def check_plugin(path, importer):
    platform, system = _PLATFORMS[os.path.splitext(path)[1]]
    enabled = {}
    for one in importer["platformData"]:
        (kind, name), = one["first"].items()
        assert one["second"]["enabled"] in ("0", "1"), path
        if kind == "Any":
            assert one["second"]["enabled"] == "0", f"{path}: for any platform"
        elif one["second"]["enabled"] == "1":
            enabled[name] = one["second"]["settings"]
    assert any("Any" in one["first"] for one in importer["platformData"]), f"{path}: nothing about any platform"
    assert set(enabled) == {"Editor", platform}, f"{path}: for {sorted(enabled)}, wanted the editor and {platform}"
    assert enabled["Editor"]["OS"] == system, f"{path}: editor on {enabled['Editor']['OS']}"
    for name, settings in enabled.items():
        assert settings["CPU"] in _PROCESSORS[platform], f"{path}: {name}: CPU {settings['CPU']}"
    assert len({settings["CPU"] for settings in enabled.values()}) == 1, f"{path}: more than one CPU"


def main(folder):
    metas, plugins, guids = [], [], {}
    for where, folders, names in os.walk(folder):
        folders[:] = sorted(name for name in folders if not name.endswith("~") and not name.startswith("."))
        for name in sorted(names + folders):
            path = os.path.join(where, name)
            if name.endswith(".meta"):
                metas.append(path)
            elif not name.endswith(".in"):
                assert os.path.exists(path + ".meta"), f"{path}: no .meta"
    for path in metas:
        with open(path, encoding="utf-8") as file:
            meta = read(file.read())
        assert meta["fileFormatVersion"] == "2", path
        assert re.fullmatch("[0-9a-f]{32}", meta["guid"]), path
        assert meta["guid"] not in guids, f"{path}: the identifier of {guids[meta['guid']]}"
        guids[meta["guid"]] = path
        of = path[:-len(".meta")]
        library = os.path.splitext(of)[1] in _PLATFORMS
        assert library == ("PluginImporter" in meta), path
        if library:
            check_plugin(of, meta["PluginImporter"])
            plugins.append(of)
    assert len(plugins) >= 1 and len(metas) >= 8, f"{len(metas)} .meta files, {len(plugins)} of libraries"
    print(f"{len(metas)} .meta files, {len(plugins)} of libraries")


if __name__ == "__main__":
    main(sys.argv[1])
