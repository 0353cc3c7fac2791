"""Archives with the same bytes on each day: names in order, one time, no owner."""
import gzip
import io
import os
import tarfile
import time
import zipfile

_EARLIEST = 315532800  # 1980, where the times of zip files begin


def moment():
    """Seconds since 1970 that every file of an archive gets: SOURCE_DATE_EPOCH, or the beginning of 1980."""
    return max(_EARLIEST, int(os.environ.get("SOURCE_DATE_EPOCH") or _EARLIEST))


def files_below(folder):
    """(path, name) of each file below `folder`; names have slashes, links are files of their own."""
    found = []
    for where, folders, names in os.walk(folder):
        folders.sort()
        for name in names:
            path = os.path.join(where, name)
            found.append((path, os.path.relpath(path, folder).replace(os.sep, "/")))
    return sorted(found, key=lambda one: one[1])


def write_zip(out, entries):
    """`entries`: (name, bytes, executable)."""
    with zipfile.ZipFile(out, "w", zipfile.ZIP_DEFLATED) as archive:
        for name, data, executable in entries:
            info = zipfile.ZipInfo(name, time.gmtime(moment())[:6])
            info.compress_type = zipfile.ZIP_DEFLATED
            info.create_system = 3
            info.external_attr = (0o100755 if executable else 0o100644) << 16
            archive.writestr(info, data)


def zip_folder(out, folder, top):
    entries = []
    for path, name in files_below(folder):
        with open(path, "rb") as file:
            entries.append((f"{top}/{name}", file.read(), os.access(path, os.X_OK)))
    write_zip(out, entries)


def tar_folder(out, folder, top):
    """A .tar.gz of `folder`, whose files unpack into the folder `top`."""
    held = io.BytesIO()
    with tarfile.open(fileobj=held, mode="w", format=tarfile.PAX_FORMAT) as archive:
        for path, name in files_below(folder):
            info = archive.gettarinfo(path, f"{top}/{name}")
            info.uid = info.gid = 0
            info.uname = info.gname = ""
            info.mtime = moment()
            info.mode = 0o755 if info.mode & 0o100 else 0o644
            if info.issym():
                archive.addfile(info)
            else:
                if info.islnk():
                    info.type, info.size, info.linkname = tarfile.REGTYPE, os.path.getsize(path), ""
                with open(path, "rb") as file:
                    archive.addfile(info, file)
    with open(out, "wb") as file, gzip.GzipFile("", "wb", 9, file, moment()) as packed:
        packed.write(held.getvalue())
