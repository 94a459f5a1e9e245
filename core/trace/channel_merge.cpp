#include "core/trace/channel_merge.h"

#include <algorithm>

namespace feedscope {
namespace {

/// Reads a channel at ascending times.
class ChannelWalk {
 public:
  explicit ChannelWalk(const TraceChannel& channel) : channel_(channel) {}

  double at(double time) {
    const std::vector<double>& times = channel_.time;
    while (next_ < times.size() && times[next_] < time) {
      ++next_;
    }
    if (next_ < times.size() && times[next_] == time) {
      return channel_.value[next_];
    }
    if (next_ == 0 || next_ == times.size()) {
      return TraceSample::missing;
    }
    const bool whole = channel_.quantity == TraceQuantity::line;
    const double share = whole ? 0 : (time - times[next_ - 1]) / (times[next_] - times[next_ - 1]);
    return channel_.value[next_ - 1] + share * (channel_.value[next_] - channel_.value[next_ - 1]);
  }

 private:
  const TraceChannel& channel_;
  std::size_t next_ = 0;
};

}  // namespace

void add_channels(const std::vector<TraceChannel>& channels, TraceBuilder& builder) {
  if (channels.empty()) {
    return;
  }
  const TraceChannel& base = *std::ranges::max_element(
      channels, {}, [](const TraceChannel& channel) { return channel.time.size(); });
  std::vector<ChannelWalk> walks;
  for (const TraceChannel& channel : channels) {
    walks.emplace_back(channel);
  }
  for (std::size_t i = 0; i < base.time.size(); ++i) {
    TraceSample sample;
    sample.time = base.time[i];
    for (std::size_t c = 0; c < channels.size(); ++c) {
      const double value = &channels[c] == &base ? base.value[i] : walks[c].at(sample.time);
      sample.set(channels[c].quantity, value);
    }
    builder.add(sample, i < base.line.size() ? base.line[i] : 0);
  }
}

}  // namespace feedscope
