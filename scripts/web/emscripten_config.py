# The settings of Debian's emscripten for the browser edition: clang-19 instead of its own clang-14, and a libc++ of the same
# version (scripts/web/install-tools). emscripten reads this file through EM_CONFIG.
import os

EMSCRIPTEN_ROOT = '/usr/share/emscripten'
LLVM_ROOT = '/usr/lib/llvm-19/bin'
BINARYEN_ROOT = '/usr'
NODE_JS = '/usr/bin/node'
FROZEN_CACHE = True
CACHE = os.environ['MOMENTSCOPE_WEB_TOOLS'] + '/cache'
if os.path.exists('/usr/bin/ccache'):
    COMPILER_WRAPPER = '/usr/bin/ccache'
