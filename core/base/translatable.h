#pragma once

// Marks a text that people see where it stands: translators find it, the text itself stays as it is. The name
// is the one that Qt and its tools know; source files only include this, since Qt defines it too.
#define QT_TRANSLATE_NOOP(scope, x) x
