#!/usr/bin/env python3
"""An installed Reye works from any folder by what lies in its prefix alone; its man page and its completion name every command
and every option of the program, and no other.

  install_test.py BUILD
"""
import functools
import os
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest

BUILD = pathlib.Path(sys.argv.pop()).resolve()
COMPLETION = "share/bash-completion/completions/reye"


def output_of(*command, **options):
    return subprocess.run([str(word) for word in command], check=True, capture_output=True, text=True, **options).stdout


def options_in(text):
    return set(re.findall(r"(?<![\w-])--[a-z][a-z-]*", text))


class Installed(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.place = tempfile.TemporaryDirectory()
        cls.addClassCleanup(cls.place.cleanup)
        cls.home = pathlib.Path(cls.place.name)
        cls.prefix = cls.home / "moved"
        output_of("cmake", "--install", BUILD, "--prefix", cls.home / "prefix")
        (cls.home / "prefix").rename(cls.prefix)
        cls.reye = cls.prefix / "bin" / "reye"

    @functools.cache
    def commands(self):
        """Commands of the help, each with its options."""
        names = re.findall(r"^  ([a-z]+) ", output_of(self.reye, "--help").split("Subcommands:")[1], re.MULTILINE)
        return {name: options_in("\n".join(re.findall(r"^  (?:-h,)?(--\S+)", output_of(self.reye, name, "--help"), re.MULTILINE)))
                for name in names}

    def test_files(self):
        for name in ("bin/reye", "bin/reye-import", "lib/reye/libreye_gmsh.so", "share/reye/scene.schema.json",
                     "share/reye/geo/hertz/cylinder_on_flat.step", "share/doc/reye/README.md", "share/doc/reye/LICENSE"):
            self.assertTrue((self.prefix / name).is_file(), name)
        scenes = {path.parent.name for path in (BUILD.parent / "geo").glob("*/scene.toml")}
        self.assertEqual(scenes, {path.parent.name for path in (self.prefix / "share/reye/geo").glob("*/scene.toml")})

    def test_nothing_of_the_build_is_asked(self):
        for name in ("bin/reye", "bin/reye-import", "lib/reye/libreye_gmsh.so"):
            self.assertNotIn(str(BUILD / "lib").encode(), (self.prefix / name).read_bytes(), name)

    def test_runs_from_elsewhere(self):
        """Neither the present folder nor PATH is asked for the importer, also where the program is called by a link."""
        elsewhere = self.home / "elsewhere"
        elsewhere.mkdir()
        (elsewhere / "reye").symlink_to(self.reye)
        trap = elsewhere / "reye-import"
        trap.write_text(f"#!/bin/sh\ntouch '{self.home}/trapped'\n", encoding="utf-8")
        trap.chmod(0o755)
        environment = {"PATH": f"{elsewhere}:{os.environ['PATH']}", "HOME": str(elsewhere)}
        scene = self.prefix / "share/reye/geo/patch/scene.toml"
        output_of("reye", "run", scene, "--out", "patch", "--quiet", cwd=elsewhere, env=environment)
        self.assertTrue((elsewhere / "patch" / "report.html").is_file())
        self.assertFalse((self.home / "trapped").exists())

    def test_man_page(self):
        page = (self.prefix / "share/man/man1/reye.1").read_text(encoding="utf-8").replace("\\-", "-").replace("\\fR", " ")
        synopsis, rest = re.sub(r"\\f[BI]", "", page).split(".SH DESCRIPTION")
        lines = {line.split()[2]: options_in(line.replace("\n", " ")) for line in synopsis.split(".br\n")
                 for line in [re.sub(r"(?s).*\.SH SYNOPSIS\n", "", line)] if line.startswith(".B reye ")}
        self.assertEqual(lines, {name: options - {"--help"} for name, options in self.commands().items()})
        explained = set().union(*self.commands().values()) | {"--version"}
        self.assertEqual(options_in("\n".join(re.findall(r"\.TP\n(.*)", rest.split(".SH EXIT")[0]))), explained)

    def completed(self, *words, cwd=None):
        """What bash offers for the last word."""
        script = f"""source '{self.prefix / COMPLETION}'; COMP_WORDS=("$@"); COMP_CWORD=$(($# - 1)); _reye; printf '%s\\n' "${{COMPREPLY[@]}}" """
        return set(output_of("bash", "-c", script, "bash", *words, cwd=cwd).split())

    def test_completion_of_words(self):
        self.assertEqual(self.completed("reye", ""), {*self.commands(), "--help", "--version"})
        for command, options in self.commands().items():
            self.assertEqual(self.completed("reye", command, "--"), options, command)

    def test_completion_of_files(self):
        folder = self.home / "files"
        (folder / "one").mkdir(parents=True)
        for name in ("scene.toml", "picture.svg", "notes.txt"):
            (folder / name).touch()
        offered = functools.partial(self.completed, "reye", cwd=folder)
        self.assertEqual(offered("run", ""), {"scene.toml", "one"})
        self.assertEqual(offered("run", "scene.toml", "--out", ""), {"one"})
        self.assertEqual(offered("check", "scene.toml", "--picture", ""), {"picture.svg", "one"})
        self.assertEqual(offered("report", ""), {"one"})
        self.assertEqual(offered("run", "scene.toml", "--threads", ""), set())


unittest.main()
