// The bus's side of the memory network.
#include "memory_bus.hpp"

#include "memory_network.hpp"

namespace foothold::test {
namespace {

class MemoryWriter final : public transport::Writer {
 public:
  MemoryWriter(std::shared_ptr<MemoryNetwork::Core> core, transport::Topic topic, const std::string& partition)
      : core_(std::move(core)), end_(core_->add_writer(topic, partition)) {}
  ~MemoryWriter() override { core_->remove(end_); }
  Result write(std::span<const std::byte> message) override { return core_->write(end_, message); }
  std::string last_error() const override { return "the memory bus refused octets that are no message"; }
  std::size_t matched() const override { return core_->matched(*end_); }
  void assert_liveliness() override { core_->assert_liveliness(*end_); }
  bool wait_acknowledged(double seconds) override { return core_->wait_acknowledged(*end_, seconds); }

 private:
  std::shared_ptr<MemoryNetwork::Core> core_;
  std::shared_ptr<WriterEnd> end_;
};

class MemoryReader final : public transport::Reader {
 public:
  MemoryReader(std::shared_ptr<MemoryNetwork::Core> core, transport::Topic topic, const std::string& partition,
               transport::ReaderEvents events)
      : core_(std::move(core)), end_(core_->add_reader(topic, partition, std::move(events))) {}
  ~MemoryReader() override { core_->remove(end_); }
  std::size_t matched() const override { return core_->matched(*end_); }

 private:
  std::shared_ptr<MemoryNetwork::Core> core_;
  std::shared_ptr<ReaderEnd> end_;
};

class MemoryBus final : public transport::Bus {
 public:
  explicit MemoryBus(std::shared_ptr<MemoryNetwork::Core> core) : core_(std::move(core)) {}
  std::unique_ptr<transport::Writer> writer(transport::Topic topic, const std::string& partition) override {
    return std::make_unique<MemoryWriter>(core_, topic, partition);
  }
  std::unique_ptr<transport::Reader> reader(transport::Topic topic, const std::string& partition,
                                            transport::ReaderEvents events) override {
    return std::make_unique<MemoryReader>(core_, topic, partition, std::move(events));
  }
  std::string_view vendor() const override { return "memory"; }
  std::string version() const override { return "1"; }

 private:
  std::shared_ptr<MemoryNetwork::Core> core_;
};

}  // namespace

MemoryNetwork::MemoryNetwork(std::uint64_t seed) : core_(std::make_shared<Core>(seed)) {}
MemoryNetwork::~MemoryNetwork() = default;

std::unique_ptr<transport::Bus> MemoryNetwork::bus() { return std::make_unique<MemoryBus>(core_); }
void MemoryNetwork::set_faults(transport::Topic topic, const Faults& faults) { core_->set_faults(topic, faults); }
std::uint64_t MemoryNetwork::written(transport::Topic topic) const { return core_->written(topic); }
bool MemoryNetwork::settle(double seconds) { return core_->settle(seconds); }

}  // namespace foothold::test
