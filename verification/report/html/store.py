"""A cache of pictures and answers, by a hash of their inputs: build/report/cache/<name>-<hash of all inputs>.json."""

import hashlib
import json
import os
from pathlib import Path


def digest(*parts):
    """Hash of texts, bytes and files (by their content; a missing file is hashed as missing)."""
    total = hashlib.blake2b(digest_size=16)
    for part in parts:
        if isinstance(part, Path):
            total.update(part.name.encode())
            part = part.read_bytes() if part.is_file() else b"missing"
        data = part.encode() if isinstance(part, str) else part
        total.update(len(data).to_bytes(8, "little"))
        total.update(data)
    return total.hexdigest()


class Store:
    def __init__(self, folder):
        self.folder = folder
        self.folder.mkdir(parents=True, exist_ok=True)
        self.made = self.kept = 0
        self.used = set()

    def path(self, name, key):
        path = self.folder / f"{name}-{key}.json"
        self.used.add(path.name)
        return path

    def find(self, name, key):
        """The value kept under this key; None if it must be made."""
        try:
            found = json.loads(self.path(name, key).read_text())
        except (OSError, ValueError):
            return None
        self.kept += 1
        return found

    def keep(self, name, key, value):
        path = self.path(name, key)
        part = path.with_suffix(".part")
        part.write_text(json.dumps(value))
        os.replace(part, path)
        self.made += 1
        return value

    def get(self, name, key, make):
        found = self.find(name, key)
        return self.keep(name, key, make()) if found is None else found

    def forget_the_rest(self):
        """Removes the entries that this report did not use."""
        for path in self.folder.glob("*.json"):
            if path.name not in self.used:
                path.unlink()
