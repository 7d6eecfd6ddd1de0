// What arrives from the bus, and the way into the client for plans.
#include "client_impl.hpp"

#include "foothold/msg/first_id.hpp"

namespace foothold::client {
namespace {

using transport::Topic;

ClientOptions with_id(ClientOptions options) {
  if (options.id == msg::kNoId) options.id = msg::random_id();
  return options;
}

}  // namespace

Client::Impl::Impl(std::unique_ptr<transport::Bus> the_bus, ClientOptions the_options)
    : options(with_id(the_options)),
      bus(std::move(the_bus)),
      directory(options.id),
      outgoing(std::make_shared<Outgoing>(*bus)),
      kept_scenes(directory, *outgoing, options.keep_scenes) {
  const std::string mine = msg::to_hex(options.id);
  steps_ = listen(Topic::kStep, mine, [this](auto message) { on_step(message); });
  events_ = listen(Topic::kEvent, mine, [this](auto message) { on_event(message); });
  robots_ = listen(Topic::kRobot, "", [this](auto message) {
    if (const auto robot = msg::decode<msg::RobotInfo>(message)) directory.add(*robot);
    wake_keeper();
  });
  scenes_ = listen(Topic::kSceneStatus, "", [this](auto message) {
    if (const auto scene = msg::decode<msg::SceneStatus>(message)) directory.add(*scene);
  });
  servers_ = listen(Topic::kServer, "", [this](auto message) { on_server(message); });
  keeper_ = std::thread([this] { keep(); });
}

Client::Impl::~Impl() {
  {
    const std::lock_guard lock(keeper_mutex_);
    stop_ = true;
  }
  keeper_work_.notify_one();
  keeper_.join();
  servers_.reset();
  robots_.reset();
  scenes_.reset();
  events_.reset();
  steps_.reset();
  delivery_.stop();
  const std::lock_guard lock(plans_mutex_);
  for (const auto& [id, plan] : plans_) plan->detach();
}

std::unique_ptr<transport::Reader> Client::Impl::listen(Topic topic, const std::string& partition,
                                                        std::function<void(std::span<const std::byte>)> on_message) {
  transport::ReaderEvents events;
  events.on_message = std::move(on_message);
  if (topic == Topic::kServer)
    events.on_liveliness = [this](std::size_t alive) {
      writers_alive_ = alive;
      wake_keeper();
    };
  return bus->reader(topic, partition, std::move(events));
}

std::shared_ptr<PlanState> Client::Impl::find(const msg::Id& id) {
  const std::lock_guard lock(plans_mutex_);
  const auto plan = plans_.find(id);
  return plan == plans_.end() ? nullptr : plan->second;
}

// For a plan whose server is lost or has refused it. kNo if nobody else can take it, kSoon if one can when it has the scene that is
// on its way. Of a lost server's any other is asked, if only to hear why it cannot.
Client::Impl::Found Client::Impl::find_another(const std::shared_ptr<PlanState>& plan, Clock::time_point now) {
  std::vector<msg::Id> had_it = plan->left();
  had_it.push_back(plan->server());
  const msg::PlanRequest request = plan->request();
  auto server = directory.choose(request, had_it, true);
  if (!server && kept_scenes.may_deliver(request, had_it)) return Found::kSoon;
  if (!server && plan->server_lost()) server = directory.choose(request, had_it, false);
  if (!server) return Found::kNo;
  if (plan->move(*server, now)) delivery_.post(plan);
  wake_keeper();
  return Found::kYes;
}

void Client::Impl::after(const std::shared_ptr<PlanState>& plan, bool news) {
  const auto now = Clock::now();
  if (plan->wants_another() && find_another(plan, now) == Found::kNo) news = plan->stay(now) || news;
  if (news) delivery_.post(plan);
  if (!plan->ended()) return;
  if (auto cancel = plan->take_farewell()) {
    const std::lock_guard lock(keeper_mutex_);
    farewells_.push_back(std::move(*cancel));
  }
  const std::lock_guard lock(plans_mutex_);
  plans_.erase(plan->id());
}

void Client::Impl::on_step(std::span<const std::byte> message) {
  const auto id = msg::first_id(message);
  const auto plan = id ? find(*id) : nullptr;
  if (!plan) return;
  auto step = msg::decode<msg::Step>(message);
  if (step) after(plan, plan->accept(std::move(*step), Clock::now()));
}

void Client::Impl::on_event(std::span<const std::byte> message) {
  const auto id = msg::first_id(message);
  const auto plan = id ? find(*id) : nullptr;
  if (!plan) return;
  const auto event = msg::decode<msg::PlanEvent>(message);
  if (!event) return;
  // Who is alive matters to an answer that nobody knows the request, or has it no more, and that is rare.
  const bool matters = event->state() == msg::UNKNOWN || event->error().code() != msg::NO_ERROR;
  const std::vector<msg::Id> alive = matters ? directory.alive() : std::vector<msg::Id>();
  after(plan, plan->accept(*event, alive, Clock::now()));
}

void Client::Impl::on_server(std::span<const std::byte> message) {
  const auto server = msg::decode<msg::ServerInfo>(message);
  if (!server) return;
  if (writers_alive_ == 0) writers_alive_ = 1;  // who is heard is alive, whatever the vendor has noticed yet
  if (directory.add(*server, Clock::now())) wake_keeper();
}

Plan Client::Impl::submit(msg::PlanRequest request, PlanCallbacks callbacks) {
  if (request.id() == msg::kNoId) request.id(msg::random_id());
  request.client(options.id);
  std::shared_ptr<PlanState> plan;
  {
    const std::lock_guard lock(plans_mutex_);
    auto& slot = plans_[request.id()];
    if (slot) return Plan(slot);
    slot = plan =
        std::make_shared<PlanState>(std::move(request), PlanState::Origin::kSubmitted, 0, std::move(callbacks), options, outgoing);
  }
  begin(plan);
  return Plan(plan);
}

Plan Client::Impl::query(const msg::Id& request, std::uint32_t from_step, PlanCallbacks callbacks) {
  std::shared_ptr<PlanState> plan;
  {
    const std::lock_guard lock(plans_mutex_);
    auto& slot = plans_[request];
    if (slot) return Plan(slot);
    msg::PlanRequest asked;
    asked.id(request);
    asked.client(options.id);
    slot = plan = std::make_shared<PlanState>(std::move(asked), PlanState::Origin::kAskedFor, from_step, std::move(callbacks),
                                              options, outgoing);
  }
  begin(plan);
  return Plan(plan);
}

void Client::Impl::begin(const std::shared_ptr<PlanState>& plan) {
  try {
    act(plan, Clock::now());
  } catch (const SendError&) {
    const std::lock_guard lock(plans_mutex_);
    plans_.erase(plan->id());
    throw;
  }
}

}  // namespace foothold::client
