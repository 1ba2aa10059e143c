# SPDX-License-Identifier: MIT
"""What a release is made of and depends on, as an SPDX 2.3 document in JSON."""
import datetime
import hashlib
import json
import uuid

import tracked

MARK = b"SPDX-License-Identifier:"
PROJECT = "SPDXRef-Package-libtdsp"
DOCUMENT = "SPDXRef-DOCUMENT"

# name, licence, what needs it, and how.
DEPENDENCIES = [
    ("glib", "LGPL-2.1-or-later", "the command tdsp", "DYNAMIC_LINK"),
    ("json-glib", "LGPL-2.1-or-later", "the command tdsp", "DYNAMIC_LINK"),
    ("cairo", "LGPL-2.1-only OR MPL-1.1", "the command tdsp", "DYNAMIC_LINK"),
    ("numpy", "BSD-3-Clause", "the Python package", "OPTIONAL_DEPENDENCY_OF"),
    ("cmocka", "Apache-2.0", "the tests", "TEST_DEPENDENCY_OF"),
    ("scdoc", "MIT", "the manual pages, when they are made", "BUILD_TOOL_OF"),
]

TYPES = {".md": ["DOCUMENTATION"], ".png": ["IMAGE"], ".tdsp": ["BINARY"], ".tdspm": ["BINARY"], ".json": ["TEXT"], ".csv": ["TEXT"], ".txt": ["TEXT"]}

# Data that others measured; examples/scenes/README.md names their sources and terms.
MEASURED = ("examples/scenes/fire-", "examples/scenes/ships-")


def _licence(path, content):
    """The licence that a file names in its first lines, and the one that it is under."""
    named = [line.partition(MARK)[2].split()[0].decode() for line in content.split(b"\n", 3)[:3] if MARK in line]
    if str(path).startswith(MEASURED):
        return "NOASSERTION", "NOASSERTION"
    return (named[0], named[0]) if named else ("NOASSERTION", "MIT")


def _file(number, path):
    content = (tracked.ROOT / path).read_bytes()
    found, concluded = _licence(path, content)
    described = {
        "SPDXID": f"SPDXRef-File-{number}",
        "fileName": f"./{path}",
        "fileTypes": TYPES.get(path.suffix, ["SOURCE"] if found != "NOASSERTION" else ["OTHER"]),
        "checksums": [{"algorithm": name, "checksumValue": hashlib.new(name.lower(), content).hexdigest()} for name in ("SHA1", "SHA256")],
        "licenseConcluded": concluded,
        "licenseInfoInFiles": [found],
        "copyrightText": "NOASSERTION" if concluded == "NOASSERTION" else "Copyright (c) 2026 libtdsp contributors",
    }
    if concluded == "NOASSERTION":
        described["comment"] = "Measured data; its source and terms are in examples/scenes/README.md."
    return described


def verification_code(files):
    """The specification's: SHA1 of the sorted SHA1 of all files."""
    sums = sorted(file["checksums"][0]["checksumValue"] for file in files)
    return hashlib.sha1("".join(sums).encode()).hexdigest()


def _dependency(name, licence, needed_by):
    return {"SPDXID": f"SPDXRef-Package-{name}", "name": name, "downloadLocation": "NOASSERTION", "filesAnalyzed": False, "licenseConcluded": licence,
            "licenseDeclared": licence, "copyrightText": "NOASSERTION", "comment": f"Not part of the release. Needed by {needed_by}.",
            "externalRefs": [{"referenceCategory": "PACKAGE-MANAGER", "referenceType": "purl", "referenceLocator": f"pkg:generic/{name}"}]}


def _relationship(name, kind):
    """X_OF says of the dependency what it is of the project; the others say it the other way round."""
    ends = (f"SPDXRef-Package-{name}", PROJECT) if kind.endswith("_OF") else (PROJECT, f"SPDXRef-Package-{name}")
    return {"spdxElementId": ends[0], "relationshipType": kind, "relatedSpdxElement": ends[1]}


def document(paths, version, epoch):
    files = [_file(number, path) for number, path in enumerate(paths)]
    code = verification_code(files)
    project = {
        "SPDXID": PROJECT, "name": "libtdsp", "versionInfo": version, "packageFileName": f"libtdsp-{version}.tar.gz", "downloadLocation": "NOASSERTION",
        "filesAnalyzed": True, "packageVerificationCode": {"packageVerificationCodeValue": code}, "licenseConcluded": "MIT", "licenseDeclared": "MIT",
        "licenseInfoFromFiles": sorted({file["licenseInfoInFiles"][0] for file in files}), "copyrightText": "Copyright (c) 2026 libtdsp contributors",
        "summary": "Time-dependent shortest paths among growing discs", "primaryPackagePurpose": "LIBRARY",
        "hasFiles": [file["SPDXID"] for file in files],
    }
    relationships = [{"spdxElementId": DOCUMENT, "relationshipType": "DESCRIBES", "relatedSpdxElement": PROJECT}]
    relationships += [_relationship(name, kind) for name, _, _, kind in DEPENDENCIES]
    made = datetime.datetime.fromtimestamp(epoch, datetime.timezone.utc).strftime("%Y-%m-%dT%H:%M:%SZ")
    return json.dumps({
        "spdxVersion": "SPDX-2.3", "dataLicense": "CC0-1.0", "SPDXID": DOCUMENT, "name": f"libtdsp-{version}",
        "documentNamespace": f"urn:uuid:{uuid.uuid5(uuid.NAMESPACE_OID, f'libtdsp {version} {code}')}",
        "creationInfo": {"created": made, "creators": ["Organization: libtdsp contributors", "Tool: libtdsp-make-dist"]},
        "packages": [project] + [_dependency(name, licence, needed_by) for name, licence, needed_by, _ in DEPENDENCIES],
        "files": files, "relationships": relationships,
    }, indent=1) + "\n"
