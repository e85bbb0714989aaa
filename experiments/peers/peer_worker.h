#ifndef TETRACONE_EXPERIMENTS_PEERS_PEER_WORKER_H
#define TETRACONE_EXPERIMENTS_PEERS_PEER_WORKER_H

namespace CLI {
class App;
}

namespace tetracone::experiments {

/// Adds the hidden `tetracone peer-worker NAME`, which the program starts itself. It answers for one peer the questions
/// from the socket that is its standard input. It ends when that is closed, even during an answer. Two more peers exist
/// for tests. They answer no to a solid question; to a surface question `crash` aborts and `hang` never answers.
void add_peer_worker_command(CLI::App& app);

}  // namespace tetracone::experiments

#endif
