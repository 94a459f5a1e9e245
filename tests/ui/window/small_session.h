#pragma once

#include <gtest/gtest.h>

#include <QFile>
#include <QTemporaryDir>

#include "tests/ui/run_fixture.h"
#include "ui/session/session.h"

namespace feedscope::test {

/// A session of one run of small_program, which is written into `folder`.
inline ui::Session small_session(const QTemporaryDir& folder) {
  QFile program(folder.filePath("part.nc"));
  EXPECT_TRUE(program.open(QIODevice::WriteOnly));
  program.write(small_program.c_str());
  ui::Session session;
  session.program = program.fileName().toStdString();
  session.runs.push_back(
      {1, {}, ui::run_colour(0), true, ui::SetupState(make_setup({"", "essid", 0.02, {}}))});
  return session;
}

}  // namespace feedscope::test
