#ifndef TETRACONE_EXPERIMENTS_PEERS_PEER_WORKER_H
#define TETRACONE_EXPERIMENTS_PEERS_PEER_WORKER_H

namespace CLI {
class App;
}

namespace tetracone::experiments {

/// Adds the hidden `tetracone peer-worker NAME`, which the program starts itself. It answers for one peer or motion
/// peer the questions from its standard input, until that is closed (peer_wire.h). It may use 4 GiB of memory. Two more
/// peers exist for tests. They answer no to a solid question; to a surface question `crash` aborts and `hang` never
/// answers.
void add_peer_worker_command(CLI::App& app);

}  // namespace tetracone::experiments

#endif
