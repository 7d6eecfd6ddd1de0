// Makes the vendors' libraries in this program deny it nothing, as an attacker would who changed them: functions of this program
// that bear the names of theirs go before theirs. What is left between it and the others is what the others check.
#include <dlfcn.h>

#include <cstring>

struct dds_qos;

// Cyclone DDS takes its access control from the library that a property names.
extern "C" [[gnu::visibility("default")]] void dds_qset_prop(dds_qos* qos, const char* name, const char* value) {
  using Set = void (*)(dds_qos*, const char*, const char*);
  static const auto genuine = reinterpret_cast<Set>(dlsym(dlopen("libddsc.so.0debian", RTLD_NOW | RTLD_NOLOAD), "dds_qset_prop"));
  genuine(qos, name, std::strcmp(name, "dds.sec.access.library.path") == 0 ? FOOTHOLD_LYING_ACCESS : value);
}

// Fast DDS's class Permissions. Its arguments are looked at by nobody but relay_only, which is written.
#define FOOTHOLD_PERMISSIONS "_ZN8eprosima8fastrtps4rtps8security11Permissions"
#define FOOTHOLD_LIE(name, mangled)                                                        \
  [[gnu::visibility("default"), gnu::used]] bool name() asm(FOOTHOLD_PERMISSIONS mangled); \
  bool name() { return true; }

FOOTHOLD_LIE(create_reader,
             "23check_create_datareaderERKNS2_6HandleEjRKNSt7__cxx1112basic_stringIcSt11char_traitsIcESaIcEEERKSt6vectorISC_"
             "SaISC_EERNS2_17SecurityExceptionE")
FOOTHOLD_LIE(create_writer,
             "23check_create_datawriterERKNS2_6HandleEjRKNSt7__cxx1112basic_stringIcSt11char_traitsIcESaIcEEERKSt6vectorISC_"
             "SaISC_EERNS2_17SecurityExceptionE")
FOOTHOLD_LIE(remote_writer, "23check_remote_datawriterERKNS2_6HandleEjRKNS1_15WriterProxyDataERNS2_17SecurityExceptionE")
FOOTHOLD_LIE(create_participant,
             "24check_create_participantERKNS2_6HandleEjRKNS1_25RTPSParticipantAttributesERNS2_17SecurityExceptionE")
FOOTHOLD_LIE(remote_participant, "24check_remote_participantERKNS2_6HandleEjRKNS1_20ParticipantProxyDataERNS2_17SecurityExceptionE")

[[gnu::visibility("default"), gnu::used]] bool remote_reader(void*, const void*, unsigned, const void*, bool& relay_only,
                                                             void*) asm(FOOTHOLD_PERMISSIONS
                                                                        "23check_remote_datareaderERKNS2_6HandleEjRKNS1_"
                                                                        "15ReaderProxyDataERbRNS2_17SecurityExceptionE");
bool remote_reader(void*, const void*, unsigned, const void*, bool& relay_only, void*) {
  relay_only = false;
  return true;
}
