#include "ui/shared/job.h"

#include <QtConcurrentRun>
#include <chrono>
#include <new>

#include "core/base/happens_before.h"
#include "ui/language/in_language.h"

namespace feedscope::ui {
namespace {

/// Work and its calls pass between threads through queues of Qt.
HappensBefore handed_over;

}  // namespace

QString failure_of(const std::function<void()>& work) {
  try {
    work();
  } catch (const Cancelled&) {
  } catch (const std::bad_alloc&) {
    return JobBase::tr("The program needs more memory than is available.");
  } catch (const std::exception& error) {
    return failure_text(error);
  }
  return {};
}

void JobControl::tell(std::function<void()> what) {
  const std::lock_guard lock(mutex_);
  if (receiver_ == nullptr) {
    return;
  }
  handed_over.before();
  QMetaObject::invokeMethod(
      receiver_,
      [self = shared_from_this(), what = std::move(what)] {
        handed_over.after();
        if (!self->progress.cancelled()) {
          what();
        }
      },
      Qt::QueuedConnection);
}

void JobControl::leave() {
  progress.cancel();
  const std::lock_guard lock(mutex_);
  receiver_ = nullptr;
}

JobBase::JobBase(QObject* parent) : QObject(parent) {
  poll_.setInterval(std::chrono::milliseconds(50));
  connect(&poll_, &QTimer::timeout, this, [this] { emit progressed(fraction()); });
  connect(&watcher_, &QFutureWatcher<Deliver>::finished, this, &JobBase::finish);
}

JobBase::~JobBase() {
  if (control_ != nullptr) {
    control_->leave();
  }
}

void JobBase::cancel() {
  next_ = nullptr;
  if (control_ != nullptr) {
    control_->progress.cancel();
  }
}

void JobBase::start_task(Task task) {
  if (busy()) {
    cancel();
    next_ = std::move(task);
  } else {
    launch(std::move(task));
    emit busy_changed(true);
  }
}

void JobBase::launch(Task task) {
  control_ = std::make_shared<JobControl>(*this);
  poll_.start();
  handed_over.before();
  watcher_.setFuture(QtConcurrent::run([task = std::move(task), control = control_] {
    handed_over.after();
    Deliver deliver = task(*control);
    handed_over.before();
    return deliver;
  }));
}

void JobBase::finish() {
  handed_over.after();
  poll_.stop();
  if (next_ != nullptr) {
    launch(std::exchange(next_, nullptr));
    return;
  }
  const bool cancelled = std::exchange(control_, nullptr)->progress.cancelled();
  const Deliver deliver = watcher_.result();
  emit busy_changed(false);
  deliver(cancelled);
}

}  // namespace feedscope::ui
