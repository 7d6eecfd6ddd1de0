// The handle: every call goes to the state that it shares.
#include "foothold/client/plan.hpp"

#include "plan_state.hpp"

namespace foothold::client {

Plan::Plan(std::shared_ptr<PlanState> state) : state_(std::move(state)) {}

const msg::Id& Plan::id() const { return state_->id(); }
msg::PlanRequest Plan::request() const { return state_->request(); }
const msg::Step* Plan::next(double seconds) { return state_->next(read_, seconds); }
std::optional<msg::PlanEvent> Plan::wait(double seconds) const { return state_->wait(seconds); }
msg::State Plan::state() const { return state_->state(); }
std::optional<msg::PlanEvent> Plan::last_event() const { return state_->last_event(); }
bool Plan::ended() const { return state_->ended(); }
msg::Id Plan::server() const { return state_->server(); }
bool Plan::server_lost() const { return state_->server_lost(); }
std::size_t Plan::steps_ready() const { return state_->steps_ready(); }
PlanTraffic Plan::traffic() const { return state_->traffic(); }
PlanTimes Plan::times() const { return state_->times(); }
PlanRecord Plan::record() const { return state_->record(); }
void Plan::cancel(const std::string& reason) { state_->cancel(reason); }

}  // namespace foothold::client
