// The members of every message, by their names in foothold.idl, for code that treats all messages alike: JSON, random contents for
// tests, comparison with a path. fields(message, f) calls f(name, member) in the order of the IDL; members of a const message are
// const or values. A test holds this list against foothold.idl.
#pragma once

#include <foothold.h>

#include <concepts>
#include <type_traits>

namespace foothold::msg {

template <class M, class T>
concept Is = std::same_as<std::remove_const_t<M>, T>;

template <Is<Vector3> M, class F>
void fields(M& m, F&& f) {
  f("x", m.x());
  f("y", m.y());
  f("z", m.z());
}

template <Is<Quaternion> M, class F>
void fields(M& m, F&& f) {
  f("w", m.w());
  f("x", m.x());
  f("y", m.y());
  f("z", m.z());
}

template <Is<Pose> M, class F>
void fields(M& m, F&& f) {
  f("position", m.position());
  f("orientation", m.orientation());
}

template <Is<Contact> M, class F>
void fields(M& m, F&& f) {
  f("limb", m.limb());
  f("frame", m.frame());
  f("face", m.face());
}

template <Is<Placement> M, class F>
void fields(M& m, F&& f) {
  f("contacts", m.contacts());
  f("base", m.base());
  f("any_orientation", m.any_orientation());
  f("joints", m.joints());
}

template <Is<Shape> M, class F>
void fields(M& m, F&& f) {
  f("kind", m.kind());
  f("body", m.body());
  f("pose", m.pose());
  f("size", m.size());
  f("vertices", m.vertices());
}

template <Is<ParameterSpec> M, class F>
void fields(M& m, F&& f) {
  f("name", m.name());
  f("kind", m.kind());
  f("unit", m.unit());
  f("default_value", m.default_value());
  f("minimum", m.minimum());
  f("maximum", m.maximum());
  f("choices", m.choices());
  f("description", m.description());
}

template <Is<Parameter> M, class F>
void fields(M& m, F&& f) {
  f("name", m.name());
  f("value", m.value());
}

template <Is<Margin> M, class F>
void fields(M& m, F&& f) {
  f("name", m.name());
  f("value", m.value());
  f("least", m.least());
  f("unit", m.unit());
}

template <Is<Attribute> M, class F>
void fields(M& m, F&& f) {
  f("name", m.name());
  f("value", m.value());
}

template <Is<Error> M, class F>
void fields(M& m, F&& f) {
  f("code", m.code());
  f("name", m.name());
  f("stage", m.stage());
  f("field", m.field());
  f("message", m.message());
  f("hint", m.hint());
  f("retryable", m.retryable());
  f("retry_after", m.retry_after());
}

template <Is<PlanRequest> M, class F>
void fields(M& m, F&& f) {
  f("id", m.id());
  f("client", m.client());
  f("server", m.server());
  f("robot", m.robot());
  f("unit", m.unit());
  f("scene", m.scene());
  f("scene_revision", m.scene_revision());
  f("start", m.start());
  f("goal", m.goal());
  f("budget", m.budget());
  f("priority", m.priority());
  f("seed", m.seed());
  f("parameters", m.parameters());
  f("shapes", m.shapes());
  f("resume", m.resume());
}

template <Is<CancelRequest> M, class F>
void fields(M& m, F&& f) {
  f("id", m.id());
  f("client", m.client());
  f("reason", m.reason());
}

template <Is<StateQuery> M, class F>
void fields(M& m, F&& f) {
  f("client", m.client());
  f("request", m.request());
  f("from_step", m.from_step());
}

template <Is<SceneChunk> M, class F>
void fields(M& m, F&& f) {
  f("upload", m.upload());
  f("client", m.client());
  f("server", m.server());
  f("name", m.name());
  f("format", m.format());
  f("revision", m.revision());
  f("size", m.size());
  f("offset", m.offset());
  f("data", m.data());
}

template <Is<MotionPoint> M, class F>
void fields(M& m, F&& f) {
  f("time", m.time());
  f("base", m.base());
  f("joints", m.joints());
}

template <Is<Step> M, class F>
void fields(M& m, F&& f) {
  f("request", m.request());
  f("server", m.server());
  f("index", m.index());
  f("label", m.label());
  f("placed", m.placed());
  f("stance", m.stance());
  f("base", m.base());
  f("joints", m.joints());
  f("motion", m.motion());
  f("margins", m.margins());
  f("attributes", m.attributes());
  f("cost", m.cost());
  f("shapes", m.shapes());
}

template <Is<Summary> M, class F>
void fields(M& m, F&& f) {
  f("steps", m.steps());
  f("cost", m.cost());
  f("lower_bound", m.lower_bound());
  f("cost_unit", m.cost_unit());
  f("optimal", m.optimal());
  f("objective", m.objective());
  f("queued", m.queued());
  f("prepared", m.prepared());
  f("planned", m.planned());
  f("plugin", m.plugin());
  f("plugin_version", m.plugin_version());
  f("server_version", m.server_version());
  f("robot", m.robot());
  f("scene", m.scene());
  f("scene_revision", m.scene_revision());
  f("parameters", m.parameters());
  f("seed", m.seed());
  f("figures", m.figures());
}

template <Is<PlanEvent> M, class F>
void fields(M& m, F&& f) {
  f("request", m.request());
  f("client", m.client());
  f("server", m.server());
  f("robot", m.robot());
  f("unit", m.unit());
  f("state", m.state());
  f("answer", m.answer());
  f("stamp", m.stamp());
  f("steps", m.steps());
  f("error", m.error());
  f("summary", m.summary());
  f("scene", m.scene());
}

template <Is<SceneStatus> M, class F>
void fields(M& m, F&& f) {
  f("key", m.key());
  f("upload", m.upload());
  f("server", m.server());
  f("state", m.state());
  f("name", m.name());
  f("format", m.format());
  f("revision", m.revision());
  f("size", m.size());
  f("stamp", m.stamp());
  f("error", m.error());
}

template <Is<RobotInfo> M, class F>
void fields(M& m, F&& f) {
  f("key", m.key());
  f("server", m.server());
  f("name", m.name());
  f("description", m.description());
  f("plugin", m.plugin());
  f("plugin_version", m.plugin_version());
  f("state", m.state());
  f("reason", m.reason());
  f("slots", m.slots());
  f("joints", m.joints());
  f("limbs", m.limbs());
  f("parameters", m.parameters());
  f("start_needs", m.start_needs());
  f("goal_needs", m.goal_needs());
}

template <Is<ServerInfo> M, class F>
void fields(M& m, F&& f) {
  f("key", m.key());
  f("name", m.name());
  f("version", m.version());
  f("protocol", m.protocol());
  f("heartbeat", m.heartbeat());
  f("uptime", m.uptime());
  f("queued", m.queued());
  f("running", m.running());
  f("slots", m.slots());
  f("stopping", m.stopping());
}

// A struct of foothold.idl, as against its numbers, strings, sequences, ids and enumerations.
template <class M>
concept Struct = requires(M& m) {
  fields(m, [](const char*, auto&&) {});
};

}  // namespace foothold::msg
