// SPDX-License-Identifier: Apache-2.0
//
// virtual_platform [model|rtl] [out.ppm]: a driver renders a torus on the shading unit.
#include <tlm_utils/simple_initiator_socket.h>

#include <chrono>
#include <fstream>
#include <iostream>
#include <memory>
#include <string>

#include "examples/virtual_platform/torus.h"
#include "model/tlm/frame_buffer_memory.h"
#include "model/tlm/shading_unit_tlm.h"
#include "model/tlm/tlm_register_bus.h"
#include "tb/rtl_shading_unit_tlm.h"

namespace example {

constexpr int kWidth = 640, kHeight = 480;
constexpr uint64_t kPlane = uint64_t{4} * kWidth * kHeight;  // bytes: colour, then depth

// The software of the platform.
class Host : public sc_core::sc_module {
 public:
  tlm_utils::simple_initiator_socket<Host> device_socket, memory_socket;

  explicit Host(const sc_core::sc_module_name& name)
      : sc_module(name), device_socket("device_socket"), memory_socket("memory_socket") {
    SC_HAS_PROCESS(Host);
    SC_THREAD(Run);
  }

  bool ok() const { return ok_; }
  const std::vector<uint8_t>& picture() const { return picture_; }  // RGBA

 private:
  void Run() {
    const shading::TriangleList scene = Torus(kWidth, kHeight);
    tlm_utils::tlm_quantumkeeper keeper;
    keeper.reset();
    shading::TlmRegisterBus bus(device_socket.operator->(), 0, &keeper);
    shading::ShadingDriver driver(&bus);

    std::vector<uint8_t> clear(kPlane, 0xff);
    Debug(tlm::TLM_WRITE_COMMAND, kPlane, &clear);
    driver.Start(scene.frame, shading::Method::kQuad, {0, 4 * kWidth, true, kPlane, 4 * kWidth});
    for (const shading::TrianglePacket& triangle : scene.triangles) driver.Push(triangle);
    driver.End();
    while (driver.Busy()) {
      keeper.inc(sc_core::sc_time(10, sc_core::SC_US));
      keeper.sync();
    }
    ok_ = driver.Error() == shading::DeviceError::kNone;
    for (const char* counter : {"TRIANGLES", "SPANS", "PIXELS", "WRITTEN", "SETUP", "CYCLES"}) {
      std::cout << counter << ' ' << driver.Counter(counter) << '\n';
    }
    picture_.resize(kPlane);
    Debug(tlm::TLM_READ_COMMAND, 0, &picture_);
    sc_core::sc_stop();
  }

  void Debug(tlm::tlm_command command, uint64_t address, std::vector<uint8_t>* bytes) {
    tlm::tlm_generic_payload payload;
    payload.set_command(command);
    payload.set_address(address);
    payload.set_data_ptr(bytes->data());
    payload.set_data_length(static_cast<unsigned>(bytes->size()));
    memory_socket->transport_dbg(payload);
  }

  std::vector<uint8_t> picture_;
  bool ok_ = false;
};

bool WritePpm(const std::string& name, const std::vector<uint8_t>& rgba) {
  std::ofstream file(name, std::ios::binary);
  file << "P6\n" << kWidth << ' ' << kHeight << "\n255\n";
  for (size_t i = 0; i < rgba.size(); i += 4) {
    file.write(reinterpret_cast<const char*>(&rgba[i]), 3);
  }
  return static_cast<bool>(file.flush());
}

std::unique_ptr<shading::ShadingDevice> CreateDevice(const std::string& core) {
  if (core == "model") return std::make_unique<shading::ShadingUnitTlm>("shading_unit");
  if (core == "rtl") return std::make_unique<shading::tb::RtlShadingUnitTlm>("shading_unit");
  return nullptr;
}

}  // namespace example

int sc_main(int argc, char** argv) {
  const auto device = example::CreateDevice(argc > 1 ? argv[1] : "model");
  if (!device || argc > 3) {
    std::cerr << "usage: virtual_platform [model|rtl] [out.ppm]\n";
    return 2;
  }
  tlm::tlm_global_quantum::instance().set(sc_core::sc_time(10, sc_core::SC_US));
  example::Host host("host");
  shading::FrameBufferMemory memory("memory", 2 * example::kPlane);
  host.device_socket.bind(device->target_socket);
  host.memory_socket.bind(memory.host_socket);
  device->initiator_socket.bind(memory.unit_socket);

  const auto begin = std::chrono::steady_clock::now();
  sc_core::sc_start();
  const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - begin;
  std::cout << "simulated time " << sc_core::sc_time_stamp() << ", " << memory.accesses()
            << " bursts, host time " << elapsed.count() << " s\n";
  const std::string name = argc > 2 ? argv[2] : "virtual_platform.ppm";
  if (!example::WritePpm(name, host.picture())) {
    std::cerr << "virtual_platform: " << name << " could not be written\n";
    return 1;
  }
  return host.ok() ? 0 : 1;
}
