#!/bin/bash
# Makes the certificates of tests/tls.rs and others anew: an authority, a server and clients of it, the same out of date, one
# that is revoked, the authority's revocation list, one that is out of date, a later one that revokes another client, one later
# still that does not, one by somebody else under the authority's name, and a client and a list of another authority. Keys of tests: whoever reads this has them. Good until 2125, so that nobody has to make them again.
set -euo pipefail
cd "$(dirname "$0")"
begin=20200101000000Z
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

key() { openssl genpkey -algorithm EC -pkeyopt ec_paramgen_curve:P-256 -out "$1" 2>/dev/null; }

# authority NAME [NAME THAT IT GIVES ITSELF]
authority() {
    key "$1.key"
    mkdir "$work/$1"
    touch "$work/$1/index.txt"
    echo 01 >"$work/$1/crlnumber"
    printf '%s\n' '[ca]' 'default_ca=d' '[d]' "database=$work/$1/index.txt" "new_certs_dir=$work/$1" 'default_md=sha256' \
        'policy=p' 'rand_serial=yes' 'unique_subject=no' "crlnumber=$work/$1/crlnumber" 'crl_extensions=list' \
        '[list]' 'authorityKeyIdentifier=keyid:always' '[p]' 'commonName=supplied' '[authority]' \
        'basicConstraints=critical,CA:TRUE' 'keyUsage=critical,keyCertSign,cRLSign' 'subjectKeyIdentifier=hash' \
        '[server]' 'basicConstraints=critical,CA:FALSE' 'keyUsage=critical,digitalSignature' 'extendedKeyUsage=serverAuth' \
        'subjectAltName=DNS:localhost,DNS:orb.example,IP:127.0.0.1' \
        '[client]' 'basicConstraints=critical,CA:FALSE' 'keyUsage=critical,digitalSignature' 'extendedKeyUsage=clientAuth' \
        >"$work/$1/conf"
    openssl req -new -key "$1.key" -subj "/CN=Orb test ${2:-$1}" -out "$work/req" 2>/dev/null
    openssl ca -batch -config "$work/$1/conf" -selfsign -keyfile "$1.key" -extensions authority -notext \
        -startdate $begin -enddate 21251231235959Z -in "$work/req" -out "$1.pem" 2>/dev/null
}

# certificate AUTHORITY KIND NAME END
certificate() {
    [ -f "$3.key" ] || key "$3.key"
    openssl req -new -key "$3.key" -subj "/CN=Orb test $3" -out "$work/req" 2>/dev/null
    openssl ca -batch -config "$work/$1/conf" -cert "$1.pem" -keyfile "$1.key" -extensions "$2" -notext \
        -startdate $begin -enddate "$4" -in "$work/req" -out "$3.pem" 2>/dev/null
}

# list AUTHORITY NAME END [BEGIN]
list() {
    openssl ca -gencrl -config "$work/$1/conf" -cert "$1.pem" -keyfile "$1.key" \
        -crl_lastupdate "${4:-$begin}" -crl_nextupdate "$3" -out "$2.crl.pem" 2>/dev/null
}

rm -f ./*.key ./*.pem
authority authority
authority other
authority forger authority
certificate authority server server 21251231235959Z
certificate authority server server-over 20200102000000Z
certificate authority client client 21251231235959Z
certificate authority client client-two 21251231235959Z
certificate authority client client-over 20200102000000Z
certificate authority client client-revoked 21251231235959Z
certificate other client client-of-other 21251231235959Z
openssl ca -config "$work/authority/conf" -cert authority.pem -keyfile authority.key -revoke client-revoked.pem 2>/dev/null
list authority authority 21251231235959Z
list authority authority-over 20200102000000Z
list authority authority-again 21251231235959Z 20200103000000Z
openssl ca -config "$work/authority/conf" -cert authority.pem -keyfile authority.key -revoke client.pem 2>/dev/null
list authority authority-later 21251231235959Z 20200102000000Z
list other other 21251231235959Z
list forger authority-forged 21251231235959Z 20200104000000Z
# What an authority signs with is needed here alone.
rm authority.key other.key forger.key forger.pem
