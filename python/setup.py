# SPDX-License-Identifier: MIT
"""The wheel: CMake builds the module, this packs it. Offline, with Debian's packages:

/usr/bin/python3 -m build --wheel --no-isolation python
"""

import re
import shutil
import subprocess
from pathlib import Path

from setuptools import Extension, setup
from setuptools.command.build_ext import build_ext
from setuptools.command.build_py import build_py

ROOT = Path(__file__).resolve().parent.parent
VERSION = re.search(r"project\(planish VERSION ([0-9.]+)", (ROOT / "CMakeLists.txt").read_text())[1]


class CMakeBuild(build_ext):
    """Copies what the target planish_python leaves in the build tree of the native preset."""

    def build_extension(self, ext):
        if not (ROOT / "build/native/build.ninja").exists():
            subprocess.run(["cmake", "--preset", "native"], cwd=ROOT, check=True)
        command = ["cmake", "--build", "--preset", "native", "--target", "planish_python"]
        subprocess.run(command, cwd=ROOT, check=True)
        name = Path(self.get_ext_filename(ext.name)).name
        target = Path(self.get_ext_fullpath(ext.name))
        target.parent.mkdir(parents=True, exist_ok=True)
        self.copy_file(ROOT / "build/native/python/planish" / name, target)


class WithCataloguePage(build_py):
    """Adds what `bash .tools/start/build.sh catalogue` has made; without it planish.catalogue() says so."""

    def run(self):
        super().run()
        page = ROOT / "build/catalogue"
        target = Path(self.build_lib) / "planish/catalogue_page"
        shutil.rmtree(target, ignore_errors=True)
        if page.is_dir():
            shutil.copytree(page, target)


setup(
    name="planish",
    version=VERSION,
    description="Edit meshes whose panels must stay flat",
    long_description=Path(__file__).with_name("README.md").read_text(encoding="utf-8"),
    long_description_content_type="text/markdown",
    license="MIT",
    python_requires=">=3.10",
    install_requires=["numpy"],
    packages=["planish"],
    package_data={"planish": ["py.typed", "*.pyi"]},
    ext_modules=[Extension("planish._core", sources=[])],
    cmdclass={"build_ext": CMakeBuild, "build_py": WithCataloguePage},
)
