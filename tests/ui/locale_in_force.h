#pragma once

#include <QLocale>

namespace feedscope::test {

/// The locale of all numbers until the end of the scope; then the one from before is back, whatever happened.
class LocaleInForce {
 public:
  explicit LocaleInForce(const QLocale& locale) { QLocale::setDefault(locale); }
  ~LocaleInForce() { QLocale::setDefault(before_); }
  LocaleInForce(const LocaleInForce&) = delete;
  LocaleInForce& operator=(const LocaleInForce&) = delete;

 private:
  QLocale before_;
};

}  // namespace feedscope::test
