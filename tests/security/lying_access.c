// Access control of Cyclone DDS that denies its own program nothing: the vendor's plugin, whose answers about ourselves and about
// others are always yes. What others think of us is theirs. Loaded by Cyclone instead of dds_security_ac (see lies.cpp). In C: the
// vendor's headers are.
#include <dds/security/dds_security_api.h>
#include <dlfcn.h>
#include <stdio.h>
#include <stdlib.h>

typedef DDS_Security_PermissionsHandle Handle;
typedef DDS_Security_DomainId Domain;
typedef DDS_Security_SecurityException Fault;
typedef DDS_Security_boolean Answer;

static Answer create_participant(dds_security_access_control* self, const Handle handle, const Domain domain,
                                 const DDS_Security_Qos* qos, Fault* fault) {
  (void)self, (void)handle, (void)domain, (void)qos, (void)fault;
  return 1;
}

static Answer create_endpoint(dds_security_access_control* self, const Handle handle, const Domain domain, const char* topic,
                              const DDS_Security_Qos* qos, const DDS_Security_PartitionQosPolicy* partition,
                              const DDS_Security_DataTags* tags, Fault* fault) {
  (void)self, (void)handle, (void)domain, (void)topic, (void)qos, (void)partition, (void)tags, (void)fault;
  return 1;
}

static Answer create_topic(dds_security_access_control* self, const Handle handle, const Domain domain, const char* topic,
                           const DDS_Security_Qos* qos, Fault* fault) {
  (void)self, (void)handle, (void)domain, (void)topic, (void)qos, (void)fault;
  return 1;
}

static Answer remote_participant(dds_security_access_control* self, const Handle handle, const Domain domain,
                                 const DDS_Security_ParticipantBuiltinTopicDataSecure* remote, Fault* fault) {
  (void)self, (void)handle, (void)domain, (void)remote, (void)fault;
  return 1;
}

static Answer remote_writer(dds_security_access_control* self, const Handle handle, const Domain domain,
                            const DDS_Security_PublicationBuiltinTopicDataSecure* remote, Fault* fault) {
  (void)self, (void)handle, (void)domain, (void)remote, (void)fault;
  return 1;
}

static Answer remote_reader(dds_security_access_control* self, const Handle handle, const Domain domain,
                            const DDS_Security_SubscriptionBuiltinTopicDataSecure* remote, Answer* relay_only, Fault* fault) {
  (void)self, (void)handle, (void)domain, (void)remote, (void)fault;
  *relay_only = 0;
  return 1;
}

static Answer remote_topic(dds_security_access_control* self, const Handle handle, const Domain domain,
                           const DDS_Security_TopicBuiltinTopicData* remote, Fault* fault) {
  (void)self, (void)handle, (void)domain, (void)remote, (void)fault;
  return 1;
}

static void* genuine(const char* function) {
  void* library = dlopen(FOOTHOLD_CYCLONE_ACCESS, RTLD_NOW | RTLD_LOCAL);
  void* found = library == NULL ? NULL : dlsym(library, function);
  if (found == NULL) {
    fprintf(stderr, "%s\n", dlerror());
    abort();
  }
  return found;
}

int init_access_control(const char* argument, void** context, struct ddsi_domaingv* domain);
int finalize_access_control(void* context);

int init_access_control(const char* argument, void** context, struct ddsi_domaingv* domain) {
  int (*init)(const char*, void**, struct ddsi_domaingv*);
  *(void**)&init = genuine("init_access_control");
  const int code = init(argument, context, domain);
  dds_security_access_control* access = *context;
  access->check_create_participant = create_participant;
  access->check_create_datawriter = create_endpoint;
  access->check_create_datareader = create_endpoint;
  access->check_create_topic = create_topic;
  access->check_remote_participant = remote_participant;
  access->check_remote_datawriter = remote_writer;
  access->check_remote_datareader = remote_reader;
  access->check_remote_topic = remote_topic;
  return code;
}

int finalize_access_control(void* context) {
  int (*finalize)(void*);
  *(void**)&finalize = genuine("finalize_access_control");
  return finalize(context);
}
