#!/bin/sh
# HexFeatureWB - LGPL-2.1-or-later
# The tests of the window, in a FreeCAD under Xvfb with settings of its own: run.sh [--pictures DIR] [TestClass[.test] ...]
# or its speed: run.sh --measure [appear] [preview] [cancel]
# FreeCAD says much; what is shown is what the tests say. FREECAD names another program than `freecad`.
set -eu
here=$(cd "$(dirname "$0")" && pwd)
if [ "${1:-}" = --pictures ]; then
  mkdir -p "$2"
  HEXFEATURE_GUI_OUT=$(cd "$2" && pwd)
  export HEXFEATURE_GUI_OUT
  shift 2
fi
if [ "${1:-}" = --measure ]; then
  export HEXFEATURE_GUI_MODULE=measure
  shift
fi
home=$(mktemp -d)
trap 'rm -rf "$home"' EXIT
mkdir -m 700 "$home/run"
mkdir "$home/Mod"
ln -s "$here/../.." "$home/Mod/HexFeatureWB"  # as a user installs it
export HEXFEATURE_GUI_TESTS="$*" HEXFEATURE_GUI_TEST_DIR="$here" FREECAD_USER_HOME="$home" XDG_RUNTIME_DIR="$home/run"
export LIBGL_ALWAYS_SOFTWARE=1 QT_QPA_PLATFORM=xcb QT_X11_NO_MITSHM=1 QTWEBENGINE_DISABLE_SANDBOX=1 QTWEBENGINE_CHROMIUM_FLAGS=--no-sandbox
# Without the start page, which opens by itself at any time, and without the report window's opening.
cat >"$home/user.cfg" <<'END'
<?xml version="1.0" encoding="UTF-8" standalone="no" ?>
<FCParameters><FCParamGroup Name="Root"><FCParamGroup Name="BaseApp"><FCParamGroup Name="Preferences">
  <FCParamGroup Name="General"><FCText Name="AutoloadModule">FemWorkbench</FCText></FCParamGroup>
  <FCParamGroup Name="Mod"><FCParamGroup Name="Start"><FCBool Name="ShowOnStartup" Value="0"/></FCParamGroup></FCParamGroup>
  <FCParamGroup Name="OutputWindow">
    <FCBool Name="checkShowReportViewOnError" Value="0"/><FCBool Name="checkShowReportViewOnWarning" Value="0"/>
    <FCBool Name="checkShowReportViewOnNormalMessage" Value="0"/><FCBool Name="checkShowReportViewOnLogMessage" Value="0"/>
  </FCParamGroup>
</FCParamGroup></FCParamGroup></FCParamGroup></FCParameters>
END
code=0
timeout "${HEXFEATURE_GUI_TIMEOUT:-600}" xvfb-run -a -s "-screen 0 1600x1000x24 +extension GLX +render -noreset" \
  "${FREECAD:-freecad}" -u "$home/user.cfg" -s "$home/system.cfg" "$here/start.py" >"$home/log" 2>&1 || code=$?
if [ -n "${HEXFEATURE_GUI_MODULE:-}" ]; then
  sed -n "/^FreeCAD [0-9]/,\$p" "$home/log"
elif [ "$code" = 0 ]; then
  grep -E "^(FreeCAD [0-9]|test_|preview of|cancelled in|[a-z ,0-9-]*: [0-9.]+ s|Ran |OK)" "$home/log" || true
else
  cat "$home/log"
fi
exit "$code"
