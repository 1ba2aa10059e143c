#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""The release: check_dist.py VERSION

Packed twice, the second time from the first one unpacked and without a repository, it is the same to the bit. The SPDX document beside it has the form
that SPDX 2.3 asks for and names exactly what is packed, with checksums that are right.
"""
import hashlib
import json
import pathlib
import re
import subprocess
import sys
import tarfile
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
FILE_TYPES = {"SOURCE", "BINARY", "ARCHIVE", "APPLICATION", "AUDIO", "IMAGE", "TEXT", "VIDEO", "DOCUMENTATION", "SPDX", "OTHER"}
RELATIONSHIPS = {"DESCRIBES", "DYNAMIC_LINK", "TEST_DEPENDENCY_OF", "OPTIONAL_DEPENDENCY_OF", "BUILD_TOOL_OF"}

failed = 0


def check(sentence, problems):
    global failed
    print(f"{'not ok' if problems else 'ok'} dist: {sentence}")
    for problem in problems[:5]:
        print(f"    {problem}")
    failed += bool(problems)


def pack(root, version, output):
    epoch = subprocess.run([root / "tools/dist/epoch.sh"], check=True, capture_output=True, text=True).stdout.strip()
    subprocess.run([sys.executable, root / "tools/dist/dist.py", version, epoch, output], check=True, stderr=subprocess.DEVNULL)
    return [(output / f"libtdsp-{version}.{ending}").read_bytes() for ending in ("tar.gz", "spdx.json")]


def missing(part, keys, where):
    return [f"{where}: {key} is missing" for key in keys if part.get(key) in (None, "", [])]


def identifiers(document):
    """Each once, of the letters that SPDX allows."""
    found = [document["SPDXID"]] + [part["SPDXID"] for part in document["packages"] + document["files"]]
    return found, [name for name in found if not re.fullmatch(r"SPDXRef-[A-Za-z0-9.-]+", name)] + (["one name twice"] if len(set(found)) < len(found) else [])


def form(document, version):
    problems = missing(document, ["dataLicense", "documentNamespace", "name", "creationInfo"], "document")
    problems += [] if document["spdxVersion"] == "SPDX-2.3" and document["dataLicense"] == "CC0-1.0" else ["not SPDX 2.3 under CC0-1.0"]
    problems += [] if re.fullmatch(r"\d{4}-\d\d-\d\dT\d\d:\d\d:\d\dZ", document["creationInfo"]["created"]) else ["created is no time"]
    problems += [f"creator {who}" for who in document["creationInfo"]["creators"] if not re.match(r"(Tool|Organization|Person): \S", who)]
    for package in document["packages"]:
        problems += missing(package, ["name", "downloadLocation", "licenseConcluded", "licenseDeclared", "copyrightText"], package["SPDXID"])
    for file in document["files"]:
        problems += missing(file, ["fileName", "checksums", "licenseConcluded", "licenseInfoInFiles", "copyrightText"], file["SPDXID"])
        problems += [f"{file['fileName']}: {kind}" for kind in file["fileTypes"] if kind not in FILE_TYPES]
    known, wrong = identifiers(document)
    for one in document["relationships"]:
        problems += [f"{one}: no such end" for end in ("spdxElementId", "relatedSpdxElement") if one[end] not in known]
        problems += [] if one["relationshipType"] in RELATIONSHIPS else [f"{one}: unknown kind"]
    problems += [] if document["packages"][0]["versionInfo"] == version else ["another version"]
    return problems + wrong


def contents(document, unpacked):
    """The files of the document and of the release, and their checksums."""
    listed = {file["fileName"].removeprefix("./"): file for file in document["files"]}
    there = {str(path.relative_to(unpacked)): path for path in unpacked.rglob("*") if path.is_file()}
    problems = [f"{name}: only in one of the two" for name in sorted(listed.keys() ^ there.keys())]
    for name in listed.keys() & there.keys():
        content = there[name].read_bytes()
        for checksum in listed[name]["checksums"]:
            if hashlib.new(checksum["algorithm"].lower(), content).hexdigest() != checksum["checksumValue"]:
                problems.append(f"{name}: its {checksum['algorithm']} is another")
    sums = sorted(hashlib.sha1(path.read_bytes()).hexdigest() for path in there.values())
    code = document["packages"][0]["packageVerificationCode"]["packageVerificationCodeValue"]
    return problems + ([] if hashlib.sha1("".join(sums).encode()).hexdigest() == code else ["the verification code is another"])


def unlike_any_release(unpacked):
    """What no release may have: built files, a repository, names of this machine."""
    made = [str(name) for name in unpacked.rglob("*") if name.suffix in (".o", ".a", ".so", ".pyc") or name.name in (".git", "__pycache__")]
    return made + [str(name) for name in [unpacked / "build"] if name.exists()]


def main(version):
    with tempfile.TemporaryDirectory() as directory:
        directory = pathlib.Path(directory)
        first = pack(ROOT, version, directory / "first")
        with tarfile.open(directory / "first" / f"libtdsp-{version}.tar.gz") as tar:
            tar.extractall(directory)
        unpacked = directory / f"libtdsp-{version}"
        check("the release has nothing that was built", unlike_any_release(unpacked))
        document = json.loads(first[1])
        check("the SPDX document has the form of SPDX 2.3", form(document, version))
        check(f"it names the {len(document['files'])} files of the release, with their checksums", contents(document, unpacked))
        second = pack(unpacked, version, directory / "second")
        check("packed again from the unpacked release it is the same to the bit", [] if first == second else ["the bytes differ"])
    return 1 if failed else 0


if __name__ == "__main__":
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    sys.exit(main(sys.argv[1]))
