#pragma once

// Marks a displayed text in place for translators; the text itself does not change. The name is the one known
// to Qt and its tools; only source files include this, since Qt also defines it.
#define QT_TRANSLATE_NOOP(scope, x) x
