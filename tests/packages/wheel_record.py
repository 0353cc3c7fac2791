"""wheel_record.py WHEEL: what RECORD says of each file holds, no file is left out, and the names of the wheel agree."""
import base64
import csv
import hashlib
import io
import os
import sys
import zipfile

archive = zipfile.ZipFile(sys.argv[1])
name, version, *tag = os.path.basename(sys.argv[1])[:-len(".whl")].split("-")
info = f"{name}-{version}.dist-info"
rows = list(csv.reader(io.StringIO(archive.read(f"{info}/RECORD").decode())))
assert sorted(row[0] for row in rows) == sorted(archive.namelist()), rows
for path, digest, size in rows:
    data = archive.read(path)
    if path == f"{info}/RECORD":
        assert (digest, size) == ("", "")
        continue
    method, value = digest.split("=", 1)
    assert value == base64.urlsafe_b64encode(hashlib.new(method, data).digest()).rstrip(b"=").decode(), path
    assert int(size) == len(data), path
assert f"Tag: {'-'.join(tag)}\n" in archive.read(f"{info}/WHEEL").decode()
metadata = archive.read(f"{info}/METADATA").decode()
assert f"Name: {name}\nVersion: {version}\n" in metadata, metadata
for needed in ("licenses/LICENSE", "licenses/NOTICES"):
    assert archive.read(f"{info}/{needed}")
