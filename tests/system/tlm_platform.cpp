// SPDX-License-Identifier: Apache-2.0
#include "tests/system/tlm_platform.h"

#include <algorithm>
#include <utility>

#include "model/tlm/shading_unit_tlm.h"
#include "tb/rtl_shading_unit_tlm.h"

namespace shading::test {
namespace {

std::unique_ptr<ShadingDevice> NewDevice(Core core, const ShadingDevice::Options& options) {
  if (core == Core::kModel) return std::make_unique<ShadingUnitTlm>("device", options);
  return std::make_unique<tb::RtlShadingUnitTlm>("device", options);
}

// A simulation starts with a kernel of its own. The one before stays until then, because every
// sc_time refers to it.
void NewKernel() {
  static std::unique_ptr<sc_core::sc_simcontext> kernel;
  auto next = std::make_unique<sc_core::sc_simcontext>();
  sc_core::sc_curr_simcontext = next.get();
  sc_core::sc_default_global_context = next.get();
  kernel = std::move(next);
}

}  // namespace

BusMonitor::BusMonitor(const sc_core::sc_module_name& name)
    : sc_module(name), device_side("device_side"), memory_side("memory_side") {
  device_side.register_b_transport(this, &BusMonitor::Transport);
}

void BusMonitor::Transport(tlm::tlm_generic_payload& payload, sc_core::sc_time& delay) {
  arrivals.push_back(sc_core::sc_time_stamp() + delay);
  memory_side->b_transport(payload, delay);
}

Platform::Platform(const sc_core::sc_module_name& name, const Setup& setup)
    : sc_module(name),
      device_socket("device_socket"),
      memory_socket("memory_socket"),
      device(NewDevice(setup.core, setup.options)),
      monitor("monitor"),
      memory("memory", kMemory, setup.memory_latency) {
  device_socket.bind(device->target_socket);
  memory_socket.bind(memory.host_socket);
  device->initiator_socket.bind(monitor.device_side);
  monitor.memory_side.bind(memory.unit_socket);
}

Software::Software(Platform* platform)
    : platform_(*platform),
      bus_(platform->device_socket.operator->(), 0, &keeper_),
      driver_(&bus_) {
  keeper_.reset();
}

void Software::Render(const TriangleList& list, Method method, const FrameBuffer& target) {
  driver_.Start(list.frame, method, target);
  for (const TrianglePacket& packet : list.triangles) driver_.Push(packet);
  driver_.End();
  WaitIdle();
}

void Software::WaitIdle() {
  while (driver_.Busy()) Wait(sc_core::sc_time(100, sc_core::SC_NS));
}

void Software::Wait(const sc_core::sc_time& time) {
  keeper_.inc(time);
  keeper_.sync();
}

tlm::tlm_response_status Software::Access(tlm::tlm_command command, uint64_t address,
                                          uint32_t* words, unsigned bytes) {
  tlm::tlm_generic_payload payload;
  payload.set_command(command);
  payload.set_address(address);
  payload.set_data_ptr(reinterpret_cast<uint8_t*>(words));
  payload.set_data_length(bytes);
  payload.set_streaming_width(bytes);
  sc_core::sc_time delay = keeper_.get_local_time();
  platform_.device_socket->b_transport(payload, delay);
  keeper_.set(delay);
  return payload.get_response_status();
}

void Software::Set(std::string_view name, uint32_t value) { bus_.Write(OffsetOf(name), &value, 1); }

void Software::Clear(uint8_t byte) {
  std::vector<uint8_t> bytes(Platform::kMemory, byte);
  tlm::tlm_generic_payload payload;
  payload.set_write();
  payload.set_address(0);
  payload.set_data_ptr(bytes.data());
  payload.set_data_length(static_cast<unsigned>(bytes.size()));
  platform_.memory_socket->transport_dbg(payload);
}

Outcome Simulate(const Setup& setup, const std::vector<Body>& bodies) {
  NewKernel();
  tlm::tlm_global_quantum::instance().set(setup.quantum);
  Platform platform("platform", setup);
  size_t returned = 0;
  for (const Body& body : bodies) {
    sc_core::sc_spawn([&platform, &returned, &body] {
      Software software(&platform);
      body(&software);
      ++returned;
    });
  }
  sc_core::sc_start();
  return {platform.memory.bytes(), returned == bodies.size()};
}

FrameBuffer TargetFor(const FrameState& frame, bool depth_test) {
  FrameBuffer target;
  target.color_stride = 4 * static_cast<uint32_t>(frame.width) + 8;
  target.depth_test = depth_test;
  target.depth_base = target.color_stride * static_cast<uint64_t>(frame.height);
  target.depth_stride = target.color_stride + 4;
  return target;
}

TriangleList Empty(int width, int height) {
  TriangleList list;
  list.frame.width = width;
  list.frame.height = height;
  const Vector3 front = {NormalComponent{}, NormalComponent{}, NormalComponent::Round(1)};
  list.frame.light = list.frame.half = list.frame.view = front;
  Material white;
  white.diffuse.fill(Reflectance::Round(1));
  list.frame.materials = {white};
  list.frame.cull = Cull::kNone;
  return list;
}

TrianglePacket Cover(int64_t depth) {
  TrianglePacket packet;
  packet.x = {ScreenCoord::Round(-10), ScreenCoord::Round(8000), ScreenCoord::Round(-10)};
  packet.y = {ScreenCoord::Round(-10), ScreenCoord::Round(-10), ScreenCoord::Round(8000)};
  packet.z.fill(VertexDepth::FromRaw(depth));
  packet.n.fill({NormalComponent{}, NormalComponent{}, NormalComponent::Round(1)});
  return packet;
}

}  // namespace shading::test
